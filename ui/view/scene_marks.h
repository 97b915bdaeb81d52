#pragma once

#include <optional>

#include <Eigen/Core>

#include <QStringList>

#include "core/scene/scene.h"
#include "ui/view/arrow_scale.h"
#include "ui/view/measuring_tools.h"

namespace ui {

/// Which quantities are drawn at the weights, and how large.
struct ShownArrows {
  bool velocities = false;
  bool forces = false;
  bool tensions = false;  ///< numbers at the ropes
  ArrowScales scales = {};

  bool operator==(const ShownArrows&) const = default;
};

/// The weight that is selected, and what a hand does with it.
struct ShownSelection {
  int weight = 0;          ///< index
  bool isMovable = false;  ///< its velocity can be taken hold of
  QStringList words;       ///< beside it, such as the angle it is dragged to
  /// Where the weight would start in a draft that cannot run.
  std::optional<core::Weight> rejected = std::nullopt;
};

/// What is drawn over a scene besides the runs: for the eyes of a class and for the hand.
struct SceneMarks {
  ShownArrows arrows;
  std::optional<ShownSelection> selection = std::nullopt;
  MeasuringTools tools;
};

}  // namespace ui
