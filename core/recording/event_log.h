#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/run/event.h"

namespace core {

/// Events of a run in time order, in bounded memory: when full, the oldest half is
/// forgotten and counted.
class EventLog {
 public:
  /// @param most  events kept, ≥ 2
  explicit EventLog(std::size_t most = 200000) : m_most(most) {}

  void append(std::span<const Event> events);
  void clear();
  /// Forgets what happened at `time` [s] and later.
  void dropFrom(double time);

  std::span<const Event> events() const { return m_events; }
  std::size_t forgotten() const { return m_forgotten; }
  /// Another number when kept events were forgotten; appending alone leaves it as it is.
  std::uint64_t revision() const { return m_revision; }

 private:
  std::size_t m_most;
  std::size_t m_forgotten = 0;
  std::uint64_t m_revision = 0;
  std::vector<Event> m_events;
};

}  // namespace core
