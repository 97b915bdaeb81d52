#include "core/recording/event_log.h"

#include <algorithm>

namespace core {

void EventLog::append(std::span<const Event> events) {
  m_events.insert(m_events.end(), events.begin(), events.end());
  if (m_events.size() <= m_most) return;
  const std::size_t surplus = m_events.size() - m_most / 2;
  m_events.erase(m_events.begin(), m_events.begin() + static_cast<std::ptrdiff_t>(surplus));
  m_forgotten += surplus;
  ++m_revision;
}

void EventLog::clear() {
  m_events.clear();
  m_forgotten = 0;
  ++m_revision;
}

void EventLog::dropFrom(double time) {
  const auto from = std::ranges::lower_bound(m_events, time, {}, &Event::time);
  if (from == m_events.end()) return;
  m_events.erase(from, m_events.end());
  ++m_revision;
}

}  // namespace core
