#pragma once

#include <vector>

#include <Eigen/Core>

#include <QString>

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;

/// A slope inside a step, as it looks in the room.
struct ShownSlope {
  QString name;
  Eigen::Vector2d place{0, 0};  ///< of the weight's center in the state it was taken at [m]
  Eigen::Vector2d way{0, 0};    ///< where the slope would lead within the whole step [m]
};

/// One step of one weight, opened up in the room.
struct ShownStep {
  Eigen::Vector2d anchor{0, 0};  ///< stays where it is when the step is drawn larger [m]
  Eigen::Vector2d start{0, 0};   ///< of the weight's center [m]
  Eigen::Vector2d end{0, 0};     ///< of the weight's center [m]
  std::vector<ShownSlope> slopes;
};

/// How many times larger than it is the step is drawn, so that its arrows can be told apart:
/// 1, 2, 5, 10, 20, …
double enlargementOf(const ShownStep& step, const Camera& camera);

/// Adds the slopes as arrows, from where they were taken along where they lead, and where the
/// step starts and ends; a note says how much larger it is drawn.
/// @param top  of the note [px]
void drawStep(const ShownStep& step, double top, const Camera& camera, const SceneLook& look,
              Drawing& drawing);

}  // namespace ui
