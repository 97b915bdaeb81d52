#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace core {

/// Color of a weight, 0 to 255 each.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Color&) const = default;
};

/// What a weight hangs on before it is cut loose.
struct Rope {
  Eigen::Vector2d pivot{0, 0};  ///< where the rope is tied [m]
  double length = 1;            ///< from pivot to the weight's center [m]
  double angle = 0;             ///< from straight down, towards +x positive [rad]
  double angularVelocity = 0;   ///< at t = 0, towards +x positive [rad/s]
  bool rigid = false;           ///< true: a rod, which never goes slack

  bool operator==(const Rope&) const = default;
};

/// A disc in the plane with the mass and the drag of a sphere. It does not spin.
struct Weight {
  double mass = 0.19;              ///< [kg]
  double radius = 0.02;            ///< [m]
  double dragCoefficient = 0.47;   ///< c_d [-]
  std::optional<Color> color;      ///< nothing: chosen by position in the list
  std::optional<Rope> rope;        ///< nothing: the weight starts free
  Eigen::Vector2d position{0, 0};  ///< of the center at t = 0 [m]; only used without a rope
  Eigen::Vector2d velocity{0, 0};  ///< at t = 0 [m/s]; only used without a rope

  bool operator==(const Weight&) const = default;
};

/// The room's lower-left inside corner is the origin; x to the right, y up.
struct Room {
  double width = 4;          ///< [m]
  double height = 3;         ///< [m]
  double restitution = 0.8;  ///< e of walls, floor and ceiling [-]
  double friction = 0;       ///< μ of walls, floor and ceiling [-]

  bool operator==(const Room&) const = default;
};

/// Which method a run uses, and how finely.
struct Solver {
  std::string method = "rk4";  ///< id in the method table
  double step = 1.0 / 60;      ///< [s]; not used by adaptive methods
  double tolerance = 1e-9;     ///< [-]; only used by adaptive methods

  bool operator==(const Solver&) const = default;
};

/// Everything the user sets. It stays constant while it runs.
struct Scene {
  std::string name;
  std::string description;
  double gravity = 9.81;    ///< downwards [m/s²]
  double airDensity = 1.2;  ///< [kg/m³]
  Room room;
  double restitution = 1;         ///< e between weights [-]
  std::optional<double> cutTime;  ///< when all ropes are cut [s]; nothing: by hand
  std::vector<Weight> weights;
  std::vector<Solver> solvers;  ///< runs that stand side by side; empty: the reader's choice

  bool operator==(const Scene&) const = default;
};

/// Where the weight's center is at t = 0 [m].
Eigen::Vector2d startPosition(const Weight& weight);

/// The weight's velocity at t = 0 [m/s].
Eigen::Vector2d startVelocity(const Weight& weight);

}  // namespace core
