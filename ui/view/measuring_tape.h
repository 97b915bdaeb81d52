#pragma once

#include <Eigen/Core>

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;

/// A tape between two places in the room that shows how far they are apart.
struct MeasuringTape {
  Eigen::Vector2d from{0, 0};  ///< [m]
  Eigen::Vector2d to{1, 0};    ///< [m]
};

/// Adds the tape with its ends to hold it by, its length, and how far it leads to the right and
/// upwards.
void drawTape(const MeasuringTape& tape, const Camera& camera, const SceneLook& look,
              Drawing& drawing);

}  // namespace ui
