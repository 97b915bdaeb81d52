#pragma once

#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "core/run/run.h"

namespace tests {

/// The events of the latest step, in an order that does not depend on how their times are rounded.
/// @param isImage  east and west change places
std::vector<std::tuple<core::EventKind, int, int>> stepEvents(const core::Run& run,
                                                              bool isImage = false);

/// Between the weights of a run and places given for them [m].
double largestDistance(const core::Run& run, const std::function<Eigen::Vector2d(int)>& place);

/// A run and what becomes of it where all starts a little aside: that says how closely anything
/// can be told there.
class RunWithTwins {
 public:
  /// @param seed  of how far aside
  RunWithTwins(const core::Scene& scene, const core::Solver& solver, std::uint32_t seed);

  /// @return  whether the run goes on
  bool advance();

  /// Whether all go the same way still: else a rounding decides.
  bool isTold() const { return m_isTold && m_uncertain < 1e-6; }
  /// How far apart they have been at most [m].
  double uncertain() const { return m_uncertain; }

  core::Run run;

 private:
  std::vector<core::Run> m_twins;
  double m_uncertain = 0;
  bool m_isTold = true;
};

}  // namespace tests
