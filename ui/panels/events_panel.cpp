#include "ui/panels/events_panel.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/control/event_navigator.h"
#include "ui/control/event_words.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/panels/event_table.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr int kRowMargin = 4;  // px above and below the words together
constexpr int kColumnMargin = 24;

}  // namespace

EventsPanel::EventsPanel(RunController* controller, EventNavigator* events, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_events(events),
      m_table(new EventTable(this)),
      m_view(new QTableView),
      m_filters(new QWidget),
      m_kinds(new QComboBox),
      m_weight(new QSpinBox),
      m_runs(new QComboBox) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(m_view);
  m_table->setTheme(Theme::of(palette()));
  buildTable();
  buildFilters();
  connect(controller, &RunController::restarted, this, &EventsPanel::listRuns);
  connect(controller, &RunController::timeShown, this, &EventsPanel::follow);
}

void EventsPanel::buildTable() {
  m_view->setModel(m_table);
  m_view->setAccessibleName(tr("Events"));
  m_view->setAccessibleDescription(
      tr("What happened in the run; choosing an event shows its moment"));
  m_view->setToolTip(m_view->accessibleDescription());
  m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_view->setAlternatingRowColors(true);
  m_view->setShowGrid(false);
  m_view->setWordWrap(false);
  m_view->setFrameShape(QFrame::NoFrame);
  m_view->setTabKeyNavigation(false);
  QHeaderView* rows = m_view->verticalHeader();
  rows->hide();
  // One height for all: no row has to be looked at to know where another is.
  rows->setSectionResizeMode(QHeaderView::Fixed);
  QHeaderView* columns = m_view->horizontalHeader();
  columns->setHighlightSections(false);
  columns->setStretchLastSection(true);
  m_view->installEventFilter(this);
  connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &EventsPanel::goToCurrent);
  connect(m_view, &QTableView::clicked, this, &EventsPanel::goToCurrent);
}

/// Room for the longest name of a kind and the sign before it [px].
int EventsPanel::kindWidth() const {
  int widest = 0;
  for (int kind = 0; kind <= static_cast<int>(core::EventKind::kRest); ++kind) {
    const QString words = eventWords(static_cast<core::EventKind>(kind));
    widest = std::max(widest, fontMetrics().horizontalAdvance(words));
  }
  return widest + 2 * fontMetrics().height() + kColumnMargin;
}

/// Columns wide enough for their names, any kind and the numbers of any two weights.
void EventsPanel::fitToFont() {
  if (m_controller->runCount() == 0) return;
  m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
  const int last = m_controller->run(0).weightCount() - 1;
  core::Event widest;
  widest.weight = widest.other = std::max(last, 0);
  const int numbers = fontMetrics().horizontalAdvance(whoWords(widest)) + kColumnMargin;
  const QHeaderView* columns = m_view->horizontalHeader();
  for (int column = 0; column < EventTable::kColumnCount; ++column) {
    const int name = columns->sectionSizeHint(column);
    const int needed = column == EventTable::kWho    ? numbers
                       : column == EventTable::kKind ? kindWidth()
                                                     : 0;
    m_view->setColumnWidth(column, std::max(name, needed));
  }
}

void EventsPanel::buildFilters() {
  auto* layout = new QHBoxLayout(m_filters);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const EventGroup group : kEventGroups) m_kinds->addItem(groupWords(group));
  m_kinds->setObjectName("eventKinds");
  m_weight->setObjectName("eventWeight");
  m_runs->setObjectName("eventRun");
  m_kinds->setAccessibleName(tr("Kinds of events"));
  m_kinds->setToolTip(tr("Kinds of events that are listed"));
  m_weight->setAccessibleName(tr("Weight whose events are listed"));
  m_weight->setToolTip(tr("Weight whose events are listed, counted from the left"));
  m_weight->setSpecialValueText(tr("All weights"));
  m_weight->setPrefix(tr("Weight "));
  m_runs->setAccessibleName(tr("Run whose events are listed"));
  m_runs->setToolTip(m_runs->accessibleName());
  m_runs->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* copyButton = new QToolButton;
  copyButton->setIcon(icon("copy"));
  copyButton->setAutoRaise(true);
  copyButton->setAccessibleName(tr("Copy as CSV"));
  copyButton->setToolTip(tr("Copy the chosen events as CSV, or all that are listed (Ctrl+C)"));
  for (QWidget* part : std::initializer_list<QWidget*>{m_kinds, m_weight, m_runs, copyButton}) {
    part->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(part);
  }
  ignoreWheelWithoutFocus(m_weight);
  connect(m_kinds, &QComboBox::currentIndexChanged, this, &EventsPanel::applyFilter);
  connect(m_weight, &QSpinBox::valueChanged, this, &EventsPanel::applyFilter);
  connect(m_runs, &QComboBox::currentIndexChanged, m_events, &EventNavigator::setRun);
  connect(m_events, &EventNavigator::runChanged, this, [this](int run) {
    m_runs->setCurrentIndex(run);
    m_table->setLog(&m_events->log());
    follow();
  });
  connect(copyButton, &QToolButton::clicked, this, &EventsPanel::copy);
}

void EventsPanel::listRuns() {
  {
    const QSignalBlocker quiet(m_runs);
    m_runs->clear();
    for (const core::Run* run : m_controller->runs()) m_runs->addItem(runWords(run->solver()));
    m_runs->setCurrentIndex(m_events->run());
  }
  m_runs->setVisible(m_controller->runCount() > 1);
  // First the log: a lower maximum may list anew, and the log before is gone.
  m_table->setLog(&m_events->log());
  m_weight->setMaximum(m_controller->run(0).weightCount());
  fitToFont();
}

void EventsPanel::setWeight(int weight) {
  m_weight->setValue(weight + 1);
}

int EventsPanel::weight() const {
  return m_weight->value() - 1;
}

void EventsPanel::applyFilter() {
  m_table->setFilter(kEventGroups[m_kinds->currentIndex()], m_weight->value() - 1);
  follow();
}

/// The row of what happened last, up to the moment shown.
void EventsPanel::follow() {
  if (!isVisible()) return;
  const QScopedValueRollback following(m_isFollowing, true);
  m_table->refresh();
  const double time = m_controller->time();
  const QModelIndex current = m_view->currentIndex();
  // Of several at one moment the one the user chose.
  if (current.isValid() && m_table->eventAt(current.row()).time == time) return;
  const int row = m_table->rowAt(time);
  if (row == current.row()) return;
  m_view->setCurrentIndex(m_table->index(row, EventTable::kTime));
  if (row < 0) m_view->scrollToTop();
}

void EventsPanel::goToCurrent() {
  const QModelIndex current = m_view->currentIndex();
  if (m_isFollowing || !current.isValid()) return;
  m_controller->pause();
  m_controller->showTime(m_table->eventAt(current.row()).time);
}

/// The chosen rows, or all where no more than the row that follows time is chosen.
void EventsPanel::copy() {
  std::vector<int> rows;
  for (const QModelIndex& index : m_view->selectionModel()->selectedRows())
    rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  if (rows.size() < 2) {
    rows.resize(m_table->rowCount());
    std::iota(rows.begin(), rows.end(), 0);
  }
  QApplication::clipboard()->setText(QString::fromStdString(m_table->csv(rows)));
  emit done(tr("Events copied as CSV: %1").arg(rows.size()));
}

bool EventsPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
    copy();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void EventsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) m_table->setTheme(Theme::of(palette()));
  if (event->type() == QEvent::FontChange) fitToFont();
}

void EventsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

}  // namespace ui
