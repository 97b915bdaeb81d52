#pragma once

#include <span>
#include <vector>

#include "core/run/event.h"

namespace ui {

/// Where a sign for an event stands.
struct TimelineMark {
  core::EventKind kind;
  double time;  ///< [s]

  bool operator==(const TimelineMark&) const = default;
};

/// So few of the events that signs of one kind do not cover each other: of each kind the first,
/// and then every first that comes at least `apart` after the one before. More events later
/// do not change the choice among those before.
///
/// @param events  in time order
/// @param apart   [s], ≥ 0
std::vector<TimelineMark> timelineMarks(std::span<const core::Event> events, double apart);

}  // namespace ui
