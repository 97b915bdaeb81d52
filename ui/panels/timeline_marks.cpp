#include "ui/panels/timeline_marks.h"

#include <map>

namespace ui {

std::vector<TimelineMark> timelineMarks(std::span<const core::Event> events, double apart) {
  std::vector<TimelineMark> marks;
  std::map<core::EventKind, double> latest;
  for (const core::Event& event : events) {
    const auto [last, isFirst] = latest.try_emplace(event.kind, event.time);
    if (!isFirst && event.time - last->second < apart) continue;
    last->second = event.time;
    marks.push_back({event.kind, event.time});
  }
  return marks;
}

}  // namespace ui
