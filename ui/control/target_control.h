#pragma once

#include <optional>

#include <QObject>

#include "ui/view/shown_target.h"

namespace core {
class Recording;
}

namespace ui {

class Commands;
class RunController;
class SceneArea;
class SceneTarget;

/// Where the weight came to the floor for the first time after the first cut, by `time` [s], as
/// far as it is recorded.
std::optional<ShownLanding> landingBy(double time, const core::Recording& recording, int weight);

/// Lets the command show the target, the mouse move it, and the views say whether it was hit.
class TargetControl : public QObject {
  Q_OBJECT

 public:
  TargetControl(const Commands& commands, const RunController* controller, SceneTarget* target,
                SceneArea* area, QObject* parent);

  SceneTarget* target() const { return m_target; }
  /// At the moment shown, with a landing for each run; nothing while the target is hidden.
  std::optional<ShownTarget> shown() const;

 private:
  void refresh();

  const Commands& m_commands;
  const RunController* m_controller;
  SceneArea* m_area;
  SceneTarget* m_target;
};

}  // namespace ui
