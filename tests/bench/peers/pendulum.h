#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace bench {

/// A pendulum on a rod of 1 m, let go at rest.
struct Pendulum {
  double angle;        ///< at t = 0, from straight down [rad]
  double drag;         ///< κ = q L [-], see core/motion/swing.h
  double pull = 9.81;  ///< g/L [1/s²]
  double length = 1;   ///< L [m]
  double until = 10;   ///< how long it is followed [s]
};

/// As a scene with nothing else in it.
core::Scene sceneOf(const Pendulum& pendulum);

/// Where it really is: Taylor polynomials of degree 24 in numbers of 64 bits of mantissa, that
/// end at turning points. Off by less than 10⁻¹⁶ rad.
class ExactPendulum {
 public:
  explicit ExactPendulum(const Pendulum& pendulum);

  /// Angle at a moment up to the pendulum's `until` [rad].
  double at(double time) const;

 private:
  using Number = long double;
  static constexpr int kDegree = 24;
  struct Stretch {
    Number begin;
    Number angle[kDegree + 1];
    Number rate[kDegree + 1];
  };
  static Number value(const Number* series, Number t);

  std::vector<Stretch> m_stretches;
};

/// Told where the pendulum is: moment [s], angle [rad].
using Watch = std::function<void(double, double)>;

/// A program's way to follow a pendulum up to its `until`.
struct PendulumSolver {
  std::string name;
  bool isOurs = false;
  bool takesTolerance = false;  ///< else steps per second
  /// @param setting  tolerance, or steps per second
  /// @param watch    told after every step, or null
  std::function<void(const Pendulum&, double setting, const Watch* watch)> solve;
};

/// Ours first: methods of fixed and adaptive step, and the reference as a whole run.
std::vector<PendulumSolver> ourSolvers();
std::vector<PendulumSolver> odeintSolvers();
std::vector<PendulumSolver> gslSolvers();
/// Ours, and all whose packages were there when the program was built.
std::vector<PendulumSolver> allSolvers();

/// Largest error of the angle after any step [rad].
double largestError(const PendulumSolver& solver, const Pendulum& pendulum,
                    const ExactPendulum& exact, double setting);

/// The coarsest of settings a tenth apart (tolerances: 10^¼) that is right to `error` [rad].
/// @return  0 if none is
double settingFor(const PendulumSolver& solver, const Pendulum& pendulum,
                  const ExactPendulum& exact, double error);

}  // namespace bench
