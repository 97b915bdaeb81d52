#include "ui/panels/charts_panel.h"

#include <algorithm>
#include <numeric>

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/recording/motion_log.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_widget.h"
#include "ui/chart/plot_heading.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/icons.h"

namespace ui {

namespace {

constexpr int kRunLetters = 6;
constexpr int kSpacing = 4;  // px: at 1280 px all tabs must stay in sight

/// Tabs whose arrow keys come before the window's while they have the focus.
class KindTabs : public QTabBar {
 public:
  using QTabBar::QTabBar;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Left || key == Qt::Key_Right) {
        event->accept();
        return true;
      }
    }
    return QTabBar::event(event);
  }
};

}  // namespace

ChartsPanel::ChartsPanel(RunController* controller, const Commands& commands, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_choosers(new QWidget),
      m_kinds(new KindTabs),
      m_weight(new QSpinBox),
      m_runs(new QComboBox),
      m_menu(new QMenu(this)),
      m_chart(new ChartWidget) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart);
  buildMenu(commands);
  buildChoosers();
  connectCommands(commands);
  connect(m_kinds, &QTabBar::currentChanged, this, &ChartsPanel::showChosen);
  connect(m_weight, &QSpinBox::valueChanged, this, &ChartsPanel::showChosen);
  connect(m_runs, &QComboBox::currentIndexChanged, this, &ChartsPanel::showChosen);
  connect(m_chart, &ChartWidget::menuRequested, m_menu,
          [this](QPoint place) { m_menu->popup(place); });
  connect(m_chart, &ChartWidget::timePicked, controller, &RunController::showTime);
  connect(controller, &RunController::restarted, this, &ChartsPanel::listRuns);
  connect(controller, &RunController::timeShown, this, [this](double time) {
    m_chart->showTime(time);
    m_chart->refresh();
  });
}

void ChartsPanel::buildChoosers() {
  for (const ChartKind& kind : chartKinds()) {
    m_kinds->setTabToolTip(m_kinds->addTab(kind.name()), kind.tip());
  }
  m_kinds->setDrawBase(false);
  m_kinds->setExpanding(false);
  m_kinds->setAccessibleName(tr("Kind of chart"));

  m_weight->setSpecialValueText(tr("All weights"));
  m_weight->setPrefix(tr("Weight "));
  m_weight->setFocusPolicy(Qt::StrongFocus);
  ignoreWheelWithoutFocus(m_weight);
  m_weight->setAccessibleName(tr("Weight in the chart"));
  m_weight->setToolTip(tr("Weight in the chart, counted from the left; 0: all"));

  m_runs->setFocusPolicy(Qt::TabFocus);
  m_runs->setAccessibleName(tr("Runs in the chart"));
  m_runs->setToolTip(tr("Runs in the chart"));
  // In the list names are whole; closed it leaves its room to the tabs.
  m_runs->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_runs->setMinimumContentsLength(kRunLetters);

  auto* more = new QToolButton;
  more->setMenu(m_menu);
  more->setPopupMode(QToolButton::InstantPopup);
  more->setIcon(icon("chart"));
  more->setAutoRaise(true);
  more->setFocusPolicy(Qt::TabFocus);
  more->setAccessibleName(tr("Chart menu"));
  more->setToolTip(tr("Zoom, copy, export, hide curves"));

  auto* layout = new QHBoxLayout(m_choosers);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kSpacing);
  layout->addWidget(m_kinds);
  layout->addWidget(m_weight);
  layout->addWidget(m_runs);
  layout->addWidget(more);
}

void ChartsPanel::buildMenu(const Commands& commands) {
  for (const Command command : {Command::kChartReset, Command::kCopyChart, Command::kCopyChartData,
                                Command::kExportChart}) {
    m_menu->addAction(commands.action(command));
  }
  m_menu->addSeparator();
  m_curves = m_menu->addMenu(tr("&Curves"));
  connect(m_menu, &QMenu::aboutToShow, this, &ChartsPanel::listCurves);
}

void ChartsPanel::connectCommands(const Commands& commands) {
  const auto on = [&](Command command, auto* receiver, auto slot) {
    connect(commands.action(command), &QAction::triggered, receiver, slot);
  };
  on(Command::kNextChart, this, &ChartsPanel::chooseNextKind);
  on(Command::kPreviousChart, this, &ChartsPanel::choosePreviousKind);
  on(Command::kChartReset, m_chart, &ChartWidget::resetZoom);
  on(Command::kCopyChart, m_chart, &ChartWidget::copyPicture);
  on(Command::kCopyChartData, m_chart, &ChartWidget::copyData);
}

ChartPicture ChartsPanel::picture() const {
  return m_chart->picture();
}

void ChartsPanel::chooseKind(int kind) {
  m_kinds->setCurrentIndex(kind);
}

int ChartsPanel::kind() const {
  return m_kinds->currentIndex();
}

void ChartsPanel::chooseRun(int run) {
  m_runs->setCurrentIndex(run + 1);
}

void ChartsPanel::chooseWeight(int weight) {
  m_weight->setValue(weight + 1);
}

int ChartsPanel::weight() const {
  return m_weight->value() - 1;
}

ChartsView ChartsPanel::view() const {
  ChartsView view{kind(), m_runs->currentIndex() - 1, weight(), {}, m_chart->plot().hidden().runs};
  const auto entries = legendCurves(m_chart->plot().content().curves);
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (m_chart->plot().hidden().names.contains(entries[i]->name)) view.hiddenCurves.insert(i);
  return view;
}

void ChartsPanel::setView(const ChartsView& view) {
  chooseKind(view.kind);
  chooseRun(view.run);
  chooseWeight(view.weight);
  HiddenCurves hidden{{}, view.hiddenRuns};
  const auto entries = legendCurves(m_chart->plot().content().curves);
  for (const std::size_t entry : view.hiddenCurves)
    if (entry < entries.size()) hidden.names.insert(entries[entry]->name);
  m_chart->setHidden(hidden);
}

void ChartsPanel::chooseNextKind() {
  m_kinds->setCurrentIndex((m_kinds->currentIndex() + 1) % m_kinds->count());
}

void ChartsPanel::choosePreviousKind() {
  m_kinds->setCurrentIndex((m_kinds->currentIndex() + m_kinds->count() - 1) % m_kinds->count());
}

void ChartsPanel::listRuns() {
  const int chosen = m_runs->currentIndex();
  {
    const QSignalBlocker quietRuns(m_runs);
    const QSignalBlocker quietWeight(m_weight);
    m_runs->clear();
    m_runs->addItem(tr("All runs"));
    for (int i = 0; i < m_controller->runCount(); ++i) m_runs->addItem(charted(i).name);
    m_runs->setCurrentIndex(chosen < m_runs->count() ? qMax(0, chosen) : 0);
    m_weight->setMaximum(static_cast<int>(m_controller->scene().weights.size()));
  }
  m_runs->view()->setMinimumWidth(m_runs->view()->sizeHintForColumn(0));
  m_runs->setVisible(m_controller->runCount() > 1);
  showChosen();
}

void ChartsPanel::showChosen() {
  const ChartKind& kind = chartKinds()[static_cast<std::size_t>(m_kinds->currentIndex())];
  m_weight->setVisible(kind.ofWeights && m_weight->maximum() > 1);
  for (const int weight : chosenWeights()) m_controller->follow(weight);
  m_chart->setSubject(kind, subject());
}

/// Only those that are followed from the start if there are many.
std::vector<int> ChartsPanel::chosenWeights() const {
  if (m_weight->value() > 0) return {m_weight->value() - 1};
  const int all = m_weight->maximum();
  std::vector<int> weights(std::min(all, core::MotionLog::kMostFromStart));
  std::iota(weights.begin(), weights.end(), 0);
  return weights;
}

ChartSubject ChartsPanel::subject() const {
  ChartSubject subject;
  subject.scene = &m_controller->scene();
  subject.weights = chosenWeights();
  const int chosen = m_runs->currentIndex() - 1;
  if (chosen >= 0) {
    subject.runs = {charted(chosen)};
    subject.firstRun = static_cast<std::size_t>(chosen);
    return subject;
  }
  for (int i = 0; i < m_controller->runCount(); ++i) subject.runs.push_back(charted(i));
  return subject;
}

ChartedRun ChartsPanel::charted(int run) const {
  const core::Recording& recording = m_controller->recording(run);
  return {&recording.ledger(), runWords(m_controller->run(run).solver()), &recording.motion()};
}

/// One entry to show or hide each curve, for those who use no mouse.
void ChartsPanel::listCurves() {
  m_curves->clear();
  for (const ChartCurve* curve : legendCurves(m_chart->plot().content().curves)) {
    QAction* action = m_curves->addAction(curve->name);
    action->setCheckable(true);
    action->setChecked(!m_chart->plot().hidden().names.contains(curve->name));
    connect(action, &QAction::toggled, this, [this, name = curve->name](bool shown) {
      HiddenCurves hidden = m_chart->plot().hidden();
      if (shown) {
        hidden.names.erase(name);
      } else {
        hidden.names.insert(name);
      }
      m_chart->setHidden(hidden);
    });
  }
}

}  // namespace ui
