#include "ui/chart/energy_chart.h"

#include <array>
#include <utility>

#include <QChart>
#include <QElapsedTimer>
#include <QEvent>
#include <QTimer>

#include "core/recording/ledger.h"
#include "ui/chart/energy_plot.h"

namespace ui {

namespace {

// A frame's time more or less, so that each second frame at 60 Hz draws.
constexpr int kShortestPause = 25;  // [ms]
constexpr double kLeastTime = 2;    // [s]
// So that an update takes well under half of a 30th of a second, the scene the rest.
constexpr std::size_t kMostPoints = 10000;
constexpr QSize kLeastSize(360, 260);

/// Tells whether a ledger was added to, cut or begun anew since it was drawn.
struct LedgerStamp {
  std::size_t size = 0;
  std::array<double, 6> values = {};

  bool operator==(const LedgerStamp&) const = default;
};

LedgerStamp stampOf(const core::Ledger& ledger) {
  const auto samples = ledger.samples();
  if (samples.empty()) return {};
  const core::EnergySample& middle = samples[samples.size() / 2];
  const core::EnergySample& last = samples.back();
  return {samples.size(),
          {samples.front().energies.accounted(), middle.time, middle.energies.kinetic, last.time,
           last.energies.kinetic, last.energies.accounted()}};
}

}  // namespace

class EnergyChart::Content : public QObject {
 public:
  explicit Content(EnergyChart* view);

  void setRuns(std::vector<ChartedRun> runs);
  void setTheme(const Theme& theme);
  void refresh();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool hasChanged() const;
  void draw();
  void remember();
  void applyLook();

  EnergyChart* m_view;  // the parent
  EnergyPlot* m_plot;   // belongs to the view's chart
  Theme m_theme;
  std::vector<LedgerStamp> m_drawn;
  QElapsedTimer m_sinceDrawn;
  QTimer m_catchUp;
};

EnergyChart::Content::Content(EnergyChart* view)
    : QObject(view),
      m_view(view),
      m_plot(new EnergyPlot(view->chart())),
      m_theme(Theme::of(view->palette())) {
  m_plot->setLeastTime(kLeastTime);
  m_plot->setMostPoints(kMostPoints);
  m_catchUp.setSingleShot(true);
  connect(&m_catchUp, &QTimer::timeout, this, &Content::refresh);
  view->installEventFilter(this);
  applyLook();
}

void EnergyChart::Content::setRuns(std::vector<ChartedRun> runs) {
  m_plot->setRuns(std::move(runs));
  remember();
}

void EnergyChart::Content::setTheme(const Theme& theme) {
  m_theme = theme;
  applyLook();
}

void EnergyChart::Content::refresh() {
  if (!m_view->isVisible() || m_catchUp.isActive() || !hasChanged()) return;
  const qint64 waited = m_sinceDrawn.isValid() ? m_sinceDrawn.elapsed() : kShortestPause;
  if (waited < kShortestPause) {
    m_catchUp.start(static_cast<int>(kShortestPause - waited));
  } else {
    draw();
  }
}

bool EnergyChart::Content::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FontChange) applyLook();
  if (event->type() == QEvent::LanguageChange) draw();
  if (event->type() == QEvent::PaletteChange) setTheme(Theme::of(m_view->palette()));
  if (event->type() == QEvent::Show && hasChanged()) draw();
  return QObject::eventFilter(watched, event);
}

bool EnergyChart::Content::hasChanged() const {
  const std::vector<ChartedRun>& runs = m_plot->runs();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (stampOf(*runs[i].ledger) != m_drawn[i]) return true;
  }
  return false;
}

void EnergyChart::Content::draw() {
  m_plot->update();
  remember();
}

void EnergyChart::Content::remember() {
  m_drawn.clear();
  for (const ChartedRun& run : m_plot->runs()) m_drawn.push_back(stampOf(*run.ledger));
  m_sinceDrawn.start();
}

void EnergyChart::Content::applyLook() {
  m_view->setBackgroundBrush(m_theme.background);
  m_plot->setLook(ChartLook::forScreen(m_theme, m_view->font()));
  remember();
}

EnergyChart::EnergyChart(QWidget* parent) : QChartView(new QChart, parent) {
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setMinimumSize(kLeastSize);
  setAccessibleName(tr("Energies over time"));
  m_content = new Content(this);
}

EnergyChart::~EnergyChart() {
  // Before the chart it works on, and while this is still a chart view.
  delete m_content;
}

void EnergyChart::setRuns(std::vector<ChartedRun> runs) {
  m_content->setRuns(std::move(runs));
}

void EnergyChart::refresh() {
  m_content->refresh();
}

void EnergyChart::setTheme(const Theme& theme) {
  m_content->setTheme(theme);
}

}  // namespace ui
