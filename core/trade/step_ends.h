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

/// The part as it would be without a method's error, as closely as the reference goes.
/// @pre part is of run.latestStep(weight) or nextStep(weight), and has stages
ExactWay exactWay(const Run& run, int weight, const StepPart& part);

/// The ends of these methods, in their order, beside the exact one.
/// @param exact  of that part
/// @pre as for exactWay(); the methods are offered to users
std::vector<StepEnd> stepEnds(const Run& run, int weight, const StepPart& part,
                              const ExactWay& exact, const std::vector<const Method*>& methods);

}  // namespace core
