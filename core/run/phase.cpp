#include "core/run/phase.h"

namespace core {

std::string_view nameOf(Phase phase) {
  switch (phase) {
    case Phase::kTethered:
      return "tethered";
    case Phase::kSlack:
      return "slack";
    case Phase::kFlying:
      return "flying";
    case Phase::kResting:
      return "resting";
  }
  return {};
}

}  // namespace core
