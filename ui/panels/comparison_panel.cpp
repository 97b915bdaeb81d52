#include "ui/panels/comparison_panel.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QTableWidget>

#include "core/recording/separation.h"
#include "core/trade/reference.h"
#include "ui/chart/figure_text.h"
#include "ui/chart/redraw_limiter.h"
#include "ui/chart/separation_chart.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/style/run_mark.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

enum Column { kName, kDistance, kDrift, kDriftShare, kEvaluations, kColumnCount };

constexpr int kPause = 100;       // ms: figures that change faster cannot be read
constexpr int kRowPadding = 6;    // px, above and below together
constexpr int kCellPadding = 12;  // px, both sides together
const QString kNothing = QStringLiteral("–");

/// Wants to be as wide as its columns are with names and figures whole.
class RunTable : public QTableWidget {
 public:
  RunTable() : QTableWidget(0, kColumnCount) {}

  QSize sizeHint() const override {
    const QHeaderView* header = horizontalHeader();
    int width = 2 * frameWidth();
    for (int column = 0; column < columnCount(); ++column)
      width += std::max({header->sectionSizeHint(column), sizeHintForColumn(column),
                         header->minimumSectionSize()});
    return {width, QTableWidget::sizeHint().height()};
  }
};

/// Which run is the reference; −1 if none is.
int referenceAmong(const std::vector<const core::Run*>& runs) {
  const auto found = std::ranges::find_if(
      runs, [](const core::Run* run) { return core::isReference(run->solver()); });
  return found == runs.end() ? -1 : static_cast<int>(found - runs.begin());
}

QTableWidgetItem* figureItem() {
  auto* item = new QTableWidgetItem;
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return item;
}

QString shareText(const core::Energies& energies) {
  constexpr double kMostPercent = 1e6;  // more says nothing that the figure in J does not
  const std::optional<double> share = energies.driftShare();
  if (!share || !(std::abs(100 * *share) <= kMostPercent)) return kNothing;
  return signedFigure(100 * *share);
}

}  // namespace

ComparisonPanel::ComparisonPanel(const RunController* controller, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_chooser(new QComboBox),
      m_table(new RunTable),
      m_chart(new SeparationChart),
      m_limiter(new RedrawLimiter(kPause, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 0, 0, 0);
  layout->addWidget(m_table);
  layout->addWidget(m_chart, 1);
  buildTable();
  m_chooser->setFocusPolicy(Qt::TabFocus);
  m_chooser->setAccessibleName(tr("Run that distances are measured from"));
  m_chooser->setToolTip(m_chooser->accessibleName());
  m_chooser->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(m_chooser, &QComboBox::currentIndexChanged, this, &ComparisonPanel::chooseBase);
  connect(controller, &RunController::restarted, this, &ComparisonPanel::listRuns);
  connect(controller, &RunController::timeShown, m_limiter, &RedrawLimiter::request);
  connect(m_limiter, &RedrawLimiter::due, this, &ComparisonPanel::showFigures);
}

QWidget* ComparisonPanel::chooser() const {
  return m_chooser;
}

void ComparisonPanel::buildTable() {
  m_table->setHorizontalHeaderLabels(
      {tr("Run"), tr("Apart (m)"), tr("Drift (J)"), tr("Drift (%)"), tr("Slopes")});
  m_table->horizontalHeaderItem(kDistance)->setToolTip(
      tr("Largest distance between the same weight in both runs, now: max |p − p'|, in m"));
  m_table->horizontalHeaderItem(kDrift)->setToolTip(
      tr("Energy the method got wrong so far, in J: kinetic + potential + losses − energy at "
         "the start"));
  m_table->horizontalHeaderItem(kDriftShare)
      ->setToolTip(tr("The same as a share of the energy at the start"));
  m_table->horizontalHeaderItem(kEvaluations)->setToolTip(tr("Slope evaluations so far"));
  m_table->horizontalHeaderItem(kName)->setToolTip(tr("Method and step of the run"));
  m_table->setAccessibleName(tr("Runs in figures"));
  m_table->setAccessibleDescription(
      tr("How far the runs are apart, and what each got wrong, at the moment shown"));
  m_table->setToolTip(m_table->accessibleDescription());
  m_table->verticalHeader()->hide();
  // One line each, so that all four are in sight in the lowest window.
  m_table->setWordWrap(false);
  QHeaderView* header = m_table->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(kName, QHeaderView::Stretch);
  header->setHighlightSections(false);
  m_table->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  m_table->setFocusPolicy(Qt::TabFocus);
  m_table->setTabKeyNavigation(false);  // Tab leaves it again
  m_table->setFrameShape(QFrame::NoFrame);
  fitToFont();
}

void ComparisonPanel::fitToFont() {
  const int row = fontMetrics().height() + kRowPadding;
  m_table->verticalHeader()->setMinimumSectionSize(row);
  m_table->verticalHeader()->setDefaultSectionSize(row);
  m_table->horizontalHeader()->setMinimumSectionSize(
      fontMetrics().horizontalAdvance(widestFigure()) + kCellPadding);
}

void ComparisonPanel::listRuns() {
  const int count = m_controller->runCount();
  const QSignalBlocker quiet(m_chooser);
  const int chosen = m_chooser->currentIndex();
  m_chooser->clear();
  m_table->setRowCount(count);
  for (int i = 0; i < count; ++i) {
    const QString name = runWords(m_controller->run(i).solver());
    m_chooser->addItem(tr("Distance from %1").arg(name));
    for (int column = 0; column < kColumnCount; ++column)
      m_table->setItem(i, column, column == kName ? new QTableWidgetItem(name) : figureItem());
    m_table->item(i, kName)->setToolTip(name);  // where it is cut off
  }
  const int reference = referenceAmong(m_controller->runs());
  const bool isNew = reference >= 0 && !m_hadReference;
  m_hadReference = reference >= 0;
  m_chooser->setCurrentIndex(isNew ? reference : std::clamp(chosen, 0, count - 1));
  m_chooser->setVisible(count > 1);
  m_table->updateGeometry();
  paintMarks();
  chooseBase();
}

void ComparisonPanel::chooseBase() {
  const int base = m_chooser->currentIndex();
  std::vector<SeparationCurve> curves;
  for (int i = 0; i < m_controller->runCount(); ++i) {
    if (i == base) continue;
    const auto place = static_cast<std::size_t>(i);
    curves.push_back({&m_controller->separations().between(place, static_cast<std::size_t>(base)),
                      runWords(m_controller->run(i).solver()), place});
  }
  m_chart->setCurves(std::move(curves));
  m_limiter->hurry();
}

void ComparisonPanel::showFigures() {
  if (!isVisible()) return;
  for (int i = 0; i < m_controller->runCount(); ++i) showRow(i);
  m_chart->refresh();
}

void ComparisonPanel::showRow(int run) {
  const core::Run& shown = m_controller->run(run);
  const core::Energies energies = shown.energiesAt(m_controller->time());
  set(run, kDistance, distanceText(run));
  set(run, kDrift, signedFigure(energies.numericalDrift));
  set(run, kDriftShare, shareText(energies));
  set(run, kEvaluations, QLocale().toString(static_cast<qlonglong>(shown.slopeEvaluations())));
}

/// Nothing for a run that has stopped: it is not at the moment shown.
QString ComparisonPanel::distanceText(int run) const {
  const int base = m_chooser->currentIndex();
  const core::Run& shown = m_controller->run(run);
  const core::Run& from = m_controller->run(base);
  const bool bothGoOn =
      shown.status() == core::RunStatus::kRunning && from.status() == core::RunStatus::kRunning;
  if (run == base || !bothGoOn) return kNothing;
  const core::Separation now = core::separationOf(shown, from, m_controller->time());
  return figure(now.distance);
}

void ComparisonPanel::set(int row, int column, const QString& text) {
  QTableWidgetItem* item = m_table->item(row, column);
  if (item->text() != text) item->setText(text);
}

void ComparisonPanel::paintMarks() {
  const Theme theme = Theme::of(palette());
  for (int i = 0; i < m_table->rowCount(); ++i)
    m_table->item(i, kName)->setIcon(QIcon(runMark(i, theme, devicePixelRatioF())));
}

void ComparisonPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paintMarks();
  if (event->type() == QEvent::FontChange) fitToFont();
}

void ComparisonPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (m_table->rowCount() > 0) m_limiter->hurry();
}

}  // namespace ui
