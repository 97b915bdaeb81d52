#include "ui/control/target_control.h"

#include <QAction>

#include "core/recording/recording.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_target.h"
#include "ui/view/scene_area.h"

namespace ui {

std::optional<ShownLanding> landingBy(double time, const core::Recording& recording, int weight) {
  bool isCut = false;
  for (const core::Event& event : recording.eventLog().events()) {
    if (event.time > time) break;
    if (isCut && event.kind == core::EventKind::kImpactFloor && event.weight == weight)
      return ShownLanding{event.position.x(), event.time};
    const bool concernsIt = event.weight < 0 || event.weight == weight;
    isCut = isCut || (event.kind == core::EventKind::kCut && concernsIt);
  }
  return std::nullopt;
}

TargetControl::TargetControl(const Commands& commands, const RunController* controller,
                             SceneTarget* target, SceneArea* area, QObject* parent)
    : QObject(parent),
      m_commands(commands),
      m_controller(controller),
      m_area(area),
      m_target(target) {
  QAction* action = commands.action(Command::kTarget);
  connect(action, &QAction::toggled, m_target, &SceneTarget::setShown);
  connect(area, &SceneArea::targetMoved, m_target, &SceneTarget::setPlace);
  connect(m_target, &SceneTarget::changed, this, &TargetControl::refresh);
  connect(controller, &RunController::timeShown, this, [this] {
    if (m_target->isShown()) refresh();
  });
}

std::optional<ShownTarget> TargetControl::shown() const {
  if (!m_target->isShown()) return std::nullopt;
  ShownTarget shown{m_target->place(), {}};
  for (int i = 0; i < m_controller->runCount(); ++i) {
    shown.landings.push_back(
        landingBy(m_controller->time(), m_controller->recording(i), m_target->weight()));
  }
  return shown;
}

void TargetControl::refresh() {
  m_commands.action(Command::kTarget)->setChecked(m_target->isShown());
  m_area->setTarget(shown());
}

}  // namespace ui
