#include "ui/panels/energy_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QVBoxLayout>

#include "ui/chart/energy_chart.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"

namespace ui {

EnergyPanel::EnergyPanel(const RunController* controller, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_chooser(new QComboBox),
      m_chart(new EnergyChart) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_chart);
  m_chooser->setFocusPolicy(Qt::TabFocus);
  m_chooser->setAccessibleName(tr("Runs in the chart"));
  m_chooser->setToolTip(tr("Runs in the chart"));
  m_chooser->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(m_chooser, &QComboBox::currentIndexChanged, this, &EnergyPanel::showChosen);
  connect(controller, &RunController::restarted, this, &EnergyPanel::listRuns);
  connect(controller, &RunController::timeShown, m_chart, &EnergyChart::refresh);
}

void EnergyPanel::listRuns() {
  const int chosen = m_chooser->currentIndex();
  {
    const QSignalBlocker quiet(m_chooser);
    m_chooser->clear();
    m_chooser->addItem(tr("All runs"));
    for (int i = 0; i < m_controller->runCount(); ++i) m_chooser->addItem(charted(i).name);
    m_chooser->setCurrentIndex(chosen < m_chooser->count() ? qMax(0, chosen) : 0);
  }
  m_chooser->setVisible(m_controller->runCount() > 1);
  showChosen();
}

void EnergyPanel::showChosen() {
  m_chart->setRuns(chosenRuns());
}

std::vector<ChartedRun> EnergyPanel::chosenRuns() const {
  const int chosen = m_chooser->currentIndex() - 1;
  if (chosen >= 0) return {charted(chosen)};
  std::vector<ChartedRun> runs;
  runs.reserve(m_controller->runCount());
  for (int i = 0; i < m_controller->runCount(); ++i) runs.push_back(charted(i));
  return runs;
}

QWidget* EnergyPanel::chooser() const {
  return m_chooser;
}

void EnergyPanel::choose(int run) {
  m_chooser->setCurrentIndex(run + 1);
}

ChartedRun EnergyPanel::charted(int run) const {
  return {&m_controller->recording(run).ledger(), runWords(m_controller->run(run).solver())};
}

void EnergyPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) m_chart->setTheme(Theme::of(palette()));
}

}  // namespace ui
