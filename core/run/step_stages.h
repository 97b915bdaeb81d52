#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/run/piece.h"

namespace core {

class Stepper;

/// One place where a method looked at the slope on its way through a step.
struct Stage {
  double node = 0;  ///< where in the step: 0 at its start, 1 at its end [-]
  /// Of this slope in the mean that leads to the end [-]; nothing if that is no such mean.
  std::optional<double> share = std::nullopt;
  Entries state = Entries::Zero();
  Entries slope = Entries::Zero();  ///< d(state)/dt there
  Eigen::Vector2d position{0, 0};   ///< of the weight's center in that state [m]
  Eigen::Vector2d velocity{0, 0};   ///< of the center in that state [m/s]
};

/// One weight's way through a step of its method, opened up; or through a part of the step,
/// where an event divides it, for the method starts anew after each.
struct StepPart {
  double begin = 0;  ///< simulated time [s]
  double end = 0;    ///< simulated time [s], > begin
  /// What the entries of the states mean. Where nothing moves the weight, and where it is one
  /// of a group in lasting contact, there are no stages: no method moves it then. Nor has the
  /// reference any, which takes no slopes.
  Mode mode = Mode::kFlight;
  std::vector<Stage> stages;  ///< in the order they were taken
  Entries beginState = Entries::Zero();
  Entries endState = Entries::Zero();
  Eigen::Vector2d beginPosition{0, 0};  ///< of the center [m]
  Eigen::Vector2d endPosition{0, 0};    ///< of the center [m]

  double duration() const { return end - begin; }
  /// What leads from the begin to the end: the mean of the slopes, d(state)/dt.
  Entries meanSlope() const { return (endState - beginState) / duration(); }
};

/// A part of a step as it would be without a method's error, from the state the part began
/// with.
struct ExactWay {
  std::vector<double> times;       ///< simulated time [s], from the part's begin to its end
  std::vector<Entries> states;     ///< one for each time
  Eigen::Vector2d position{0, 0};  ///< of the center at the end [m]

  const Entries& end() const { return states.back(); }
};

/// Opens a piece: takes the method's step from its begin to its end once more, and keeps
/// what the method saw. The piece's own end stays: an event may have set it.
///
/// @param stepper    moved the piece; a copy, so that nothing counts as work of the run
/// @param stepStart  simulated time where the piece's step begins [s]
/// @pre piece.end > piece.begin
StepPart opened(const Body& body, const Piece& piece, Stepper stepper, double stepStart);

}  // namespace core
