#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/run/run.h"
#include "core/scene/scene.h"

namespace tests {

/// Weights of mixed size over the floor of a narrow room, about to fall into it; friction 0.2.
///
/// @param count        of weights, ≥ 1
/// @param restitution  of the room and of the weights
/// @param seed         of their sizes, places and velocities
std::shared_ptr<const core::Scene> pouredHeap(int count, double restitution,
                                              std::uint32_t seed = 1);

/// A disc in the room [m].
struct PlacedDisc {
  Eigen::Vector2d center;
  double radius;
};

/// How far two discs overlap at most [m]; 0 if none do.
double largestOverlap(std::vector<PlacedDisc> discs);

/// The same of a run's weights.
double largestOverlap(const core::Run& run);

/// What became of a heap, for the bounds it must keep.
struct HeapFigures {
  bool finished = true;        ///< no step was given up
  double overlap = 0;          ///< largest after any step [m]
  double kinetic = 0;          ///< at the end [J]
  double highestEnergy = 0;    ///< mechanical, after any step, as a share of the start's
  double drift = 0;            ///< energy unaccounted for at the end, as a share of the start's
  double largestGain = 0;      ///< of that in one step, likewise
  std::size_t mostEvents = 0;  ///< listed in one step
};

/// Runs the heap for that long [s].
HeapFigures runHeap(const std::shared_ptr<const core::Scene>& scene, const core::Solver& solver,
                    double duration);

}  // namespace tests
