#include "core/trade/step_ends.h"

#include "core/trade/reference.h"

namespace core {

ExactWay exactWay(const Run& run, int weight, const StepPart& part) {
  return run.exactWay(weight, part, kReferenceTolerance);
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
