#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/methods/method.h"
#include "core/run/run.h"

namespace core {

/// Where a method leads a weight from the start of a part of a step to its end.
struct StepEnd {
  const Method* method = nullptr;
  Entries state = Entries::Zero();
  Eigen::Vector2d position{0, 0};  ///< of the center [m]
  double error = 0;                ///< distance from the exact place [m]
};

/// A part of a step as it would be without any method's error: from the state the part began
/// with, by so many small steps of Runge–Kutta 4 that rounding is all that is left.
struct ExactWay {
  std::vector<double> times;       ///< simulated time [s], from the part's begin to its end
  std::vector<Entries> states;     ///< one for each time
  Eigen::Vector2d position{0, 0};  ///< of the center at the end [m]

  const Entries& end() const { return states.back(); }
};

/// Small steps an exact way is made of.
inline constexpr int kStepsOfExactWay = 1024;

/// @pre part is of run.latestStep(weight) or nextStep(weight), and has stages
ExactWay exactWay(const Run& run, int weight, const StepPart& part);

/// The ends of these methods, in their order, beside the exact one.
/// @pre as for exactWay(), and `exact` is of that part
std::vector<StepEnd> stepEnds(const Run& run, int weight, const StepPart& part,
                              const ExactWay& exact, const std::vector<const Method*>& methods);

}  // namespace core
