#include "ui/window_memory.h"

#include <QAction>
#include <QMainWindow>

#include "ui/chart/chart_kind.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/settings.h"
#include "ui/panels/charts_panel.h"

namespace ui {
namespace {

struct Switch {
  Command command;
  const char* name;  // in the settings
};

/// Those that change how things look, for good.
constexpr Switch kSwitches[] = {{Command::kTrails, "trails"},
                                {Command::kSplit, "splitViews"},
                                {Command::kVelocities, "velocities"},
                                {Command::kForces, "forces"},
                                {Command::kTensions, "tensions"}};

}  // namespace

void WindowMemory::restore() const {
  const Settings settings;
  m_window->restoreGeometry(settings.geometry());
  m_controller->setSpeed(settings.speed());
  chooseChart(settings.chartKind());
  for (const auto& [command, name] : kSwitches) {
    QAction* action = m_commands.action(command);
    action->setChecked(settings.isOn(name, action->isChecked()));
  }
}

void WindowMemory::chooseChart(const QString& id) const {
  const std::span<const ChartKind> kinds = chartKinds();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (id == QLatin1String(kinds[i].id)) m_charts->chooseKind(static_cast<int>(i));
}

void WindowMemory::save() const {
  // A presentation is not how a window is left.
  m_commands.action(Command::kPresent)->setChecked(false);
  Settings settings;
  settings.setGeometry(m_window->saveGeometry());
  settings.setPanels(m_window->saveState());
  settings.setSpeed(m_controller->speed());
  settings.setChartKind(chartKinds()[static_cast<std::size_t>(m_charts->kind())].id);
  for (const auto& [command, name] : kSwitches)
    settings.setOn(name, m_commands.action(command)->isChecked());
}

}  // namespace ui
