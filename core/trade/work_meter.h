#pragma once

#include <functional>
#include <mutex>
#include <utility>

namespace core {

/// Called now and then by long work with the share that is done, 0 to 1. Returns false to stop
/// the work. May be called by several threads, but by one at a time.
using Progress = std::function<bool(double share)>;

/// Adds up what is done of some work, and asks whether to go on. For use by several threads.
class WorkMeter {
 public:
  /// @param total     all the work, in any unit, > 0
  /// @param progress  may be empty: then nothing stops the work
  WorkMeter(double total, Progress progress) : m_total(total), m_progress(std::move(progress)) {}

  /// Counts work as done.
  /// @return  false once the work is to stop
  bool add(double work);

 private:
  double m_total;
  Progress m_progress;
  std::mutex m_mutex;
  double m_done = 0;
  bool m_goesOn = true;
};

}  // namespace core
