#pragma once

#include <cstddef>
#include <map>

#include "core/recording/even_series.h"
#include "core/run/run.h"

namespace core {

/// One weight at one moment.
struct MotionSample {
  double time = 0;  ///< [s]
  WeightState weight;
};

/// How single weights of a run move over time, for curves: in bounded memory, each weight's
/// past covered evenly.
///
/// Follows the first kMostFromStart weights from the start, and any others once asked to.
class MotionLog {
 public:
  static constexpr int kMostFromStart = 24;

  using Track = EvenSeries<MotionSample>;

  /// Starts anew with the run as it is now.
  void start(const Run& run);
  /// The step the run has just taken.
  void append(const Run& run);
  /// Forgets what came after `time` [s].
  void dropAfter(double time);

  /// Follows one more weight from now on.
  /// @param past  what is known of it so far, in time order
  /// @pre the weight is not followed yet
  void follow(int weight, const std::vector<MotionSample>& past);

  /// Null if the weight is not followed. Lives until the next start().
  const Track* track(int weight) const;

 private:
  std::map<int, Track> m_tracks;
};

}  // namespace core
