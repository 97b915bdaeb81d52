#include "core/run/event.h"

namespace core {

std::string_view nameOf(EventKind kind) {
  switch (kind) {
    case EventKind::kCut:
      return "cut";
    case EventKind::kTurningPoint:
      return "turning-point";
    case EventKind::kSlack:
      return "slack";
    case EventKind::kTaut:
      return "taut";
    case EventKind::kImpactFloor:
      return "impact-floor";
    case EventKind::kImpactCeiling:
      return "impact-ceiling";
    case EventKind::kImpactWest:
      return "impact-west";
    case EventKind::kImpactEast:
      return "impact-east";
    case EventKind::kImpactWeight:
      return "impact-weight";
    case EventKind::kRest:
      return "rest";
  }
  return {};
}

}  // namespace core
