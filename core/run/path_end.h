#pragma once

#include "core/methods/method.h"

namespace core {

/// d(state)/ds of a method's path at the end of a step, for one weight or a batch; for a path
/// of the method's own the slope there.
///
/// @param slope       f in dx/dt = f(x), asked only where the path ends with it
/// @param begin, end  state at both ends of the step
/// @param beginSlope  f(begin)
/// @param duration    of the step [s], ≥ 0
template <class Slope, class State>
State pathEndSlope(PathShape path, const Slope& slope, const State& begin, const State& end,
                   const State& beginSlope, double duration) {
  switch (path) {
    case PathShape::kStraight:
      return beginSlope;
    case PathShape::kParabola:
      if (duration <= 0) return beginSlope;
      return 2 / duration * (end - begin) - beginSlope;
    case PathShape::kCubic:
    case PathShape::kQuartic:
    case PathShape::kPolynomial:
      break;
  }
  return slope(end);
}

}  // namespace core
