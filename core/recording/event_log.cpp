#include "core/recording/event_log.h"

#include <algorithm>

namespace core {

void EventLog::append(std::span<const Event> events) {
  m_events.insert(m_events.end(), events.begin(), events.end());
  if (m_events.size() <= m_most) return;
  const std::size_t surplus = m_events.size() - m_most / 2;
  m_events.erase(m_events.begin(), m_events.begin() + static_cast<std::ptrdiff_t>(surplus));
  m_forgotten += surplus;
}

void EventLog::clear() {
  m_events.clear();
  m_forgotten = 0;
}

void EventLog::dropFrom(double time) {
  m_events.erase(std::ranges::lower_bound(m_events, time, {}, &Event::time), m_events.end());
}

}  // namespace core
