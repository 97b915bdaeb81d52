#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/recording/even_series.h"
#include "core/run/run.h"

namespace core {

/// How far two runs of one scene are apart at one moment: the largest distance between the
/// places of the same weight.
struct Separation {
  double time = 0;      ///< [s]
  double distance = 0;  ///< between the centers [m]
  int weight = -1;      ///< the weight that is furthest apart; −1 if there is none
};

/// @param time  [s], inside the latest step of both runs
/// @pre both are runs of one scene
Separation separationOf(const Run& a, const Run& b, double time);

/// Two runs' distance over time, in time order.
using SeparationSeries = EvenSeries<Separation>;

/// How far the runs of one scene are apart over time, each from each, in bounded memory.
///
/// A sample is taken whenever the run with the largest step ends one: the moments depend on
/// the runs alone, not on when anybody looked.
class SeparationLog {
 public:
  /// @param most  samples kept of each pair, ≥ 4
  explicit SeparationLog(std::size_t most = 10000) : m_most(most) {}

  /// Starts anew with these runs as they are now.
  void start(std::span<const Run* const> runs);

  /// Takes a sample if one is due. Call after each advance of any run, always of the one
  /// that is furthest behind, so that the latest steps have the earliest of their ends in
  /// common. Runs that have stopped are compared no more.
  /// @pre the runs are as many as start() was told
  void note(std::span<const Run* const> runs);

  /// Forgets what came after `time` [s].
  void dropAfter(double time);

  /// Of runs a and b, in either order.
  /// @pre a ≠ b, both below the number of runs
  const SeparationSeries& between(std::size_t a, std::size_t b) const;

 private:
  void sample(std::span<const Run* const> runs, double time);

  std::size_t m_most;
  std::size_t m_runCount = 0;
  double m_latest = 0;                    // time of the latest sample [s]
  std::vector<SeparationSeries> m_pairs;  // (0, 1), (0, 2), (1, 2), (0, 3), …
};

}  // namespace core
