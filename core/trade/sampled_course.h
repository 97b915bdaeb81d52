#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace core {

/// Evenly spaced moments from 0 to an end, both included.
class SampleTimes {
 public:
  /// Close enough that the largest of a smoothly changing quantity is hardly missed, and few
  /// enough that the positions of so many weights fit into memory.
  /// @param until  [s], ≥ 0
  SampleTimes(double until, int weightCount);

  int count() const { return m_intervals + 1; }
  /// [s]: a multiple of the spacing, because a sum would drift.
  double at(int moment) const;

 private:
  double m_until;
  int m_intervals;
};

/// Where all weights of a scene are at one moment after the other.
class SampledCourse {
 public:
  explicit SampledCourse(int weightCount) : m_weightCount(static_cast<std::size_t>(weightCount)) {}

  /// @param positions  of all weights, shape (weight count) [m]
  void append(std::span<const Eigen::Vector2d> positions);

  int count() const { return m_count; }
  /// @pre moment < count()
  std::span<const Eigen::Vector2d> at(int moment) const;

 private:
  std::size_t m_weightCount;
  int m_count = 0;
  std::vector<Eigen::Vector2d> m_positions;  // moment by moment
};

/// Largest distance between the two places of any weight [m].
/// @pre both hold as many weights
double largestDistance(std::span<const Eigen::Vector2d> a, std::span<const Eigen::Vector2d> b);

}  // namespace core
