#pragma once

#include <Eigen/Core>

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;

/// Two arms from one vertex that show the angle between them.
struct Protractor {
  Eigen::Vector2d vertex{0, 0};  ///< [m]
  Eigen::Vector2d first{1, 0};   ///< end of one arm [m]
  Eigen::Vector2d second{0, 1};  ///< end of the other [m]

  /// Between the arms [rad], 0 to π.
  double angle() const;
};

/// Adds the arms, an arc from one to the other and the angle in degrees.
void drawProtractor(const Protractor& protractor, const Camera& camera, const SceneLook& look,
                    Drawing& drawing);

}  // namespace ui
