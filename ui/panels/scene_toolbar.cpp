#include "ui/panels/scene_toolbar.h"

#include <initializer_list>

#include <QAction>
#include <QCoreApplication>
#include <QToolBar>

#include "ui/control/commands.h"

namespace ui {
namespace {

constexpr QSize kIconSize(24, 24);

}  // namespace

QToolBar* sceneToolbar(const Commands& commands) {
  auto* bar = new QToolBar;
  bar->setObjectName("sceneTools");
  bar->setOrientation(Qt::Vertical);
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  bar->setIconSize(kIconSize);
  bar->setAccessibleName(QCoreApplication::translate("ui::SceneToolbar", "Scene tools"));
  const auto add = [&](std::initializer_list<Command> list) {
    for (const Command command : list) bar->addAction(commands.action(command));
  };
  add({Command::kTrails, Command::kVelocities, Command::kForces, Command::kTensions});
  bar->addSeparator();
  add({Command::kTape, Command::kProtractor, Command::kStopwatch});
  for (QAction* action : bar->actions())
    if (!action->isSeparator()) bar->widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
  return bar;
}

}  // namespace ui
