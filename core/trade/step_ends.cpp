#include "core/trade/step_ends.h"

namespace core {
namespace {

constexpr int kStepsPerTime = 16;  // of the small steps, between the states that are kept

}  // namespace

ExactWay exactWay(const Run& run, int weight, const StepPart& part) {
  const Method& method = *findMethod("rk4");
  const double step = part.duration() / kStepsOfExactWay;
  ExactWay way{.times = {part.begin}, .states = {part.beginState}, .position = part.beginPosition};
  StepPart small = part;
  Entries state = part.beginState;
  for (int i = 0; i < kStepsOfExactWay; ++i) {
    small.begin = part.begin + i * step;
    small.end = small.begin + step;
    small.beginState = state;
    const StepPart taken = run.retaken(weight, small, method);
    state = taken.endState;
    way.position = taken.endPosition;
    if ((i + 1) % kStepsPerTime != 0) continue;
    way.times.push_back(part.begin + (i + 1) * step);
    way.states.push_back(state);
  }
  return way;
}

std::vector<StepEnd> stepEnds(const Run& run, int weight, const StepPart& part,
                              const ExactWay& exact, const std::vector<const Method*>& methods) {
  std::vector<StepEnd> ends;
  ends.reserve(methods.size());
  for (const Method* method : methods) {
    const StepPart taken = run.retaken(weight, part, *method);
    ends.push_back(
        {method, taken.endState, taken.endPosition, (taken.endPosition - exact.position).norm()});
  }
  return ends;
}

}  // namespace core
