#include "tests/support/heap.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace tests {

std::shared_ptr<const core::Scene> pouredHeap(int count, double restitution, std::uint32_t seed) {
  auto scene = std::make_shared<core::Scene>();
  std::mt19937 generator(seed);
  const auto share = [&] { return static_cast<double>(generator()) / 4294967296.0; };
  constexpr double kCell = 0.1;
  const int columns = std::max(3, static_cast<int>(std::sqrt(count / 4.0)));
  const int rows = count / columns + 1;
  scene->room = {.width = columns * kCell,
                 .height = rows * kCell + 0.5,
                 .restitution = restitution,
                 .friction = 0.2};
  scene->restitution = restitution;
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns;
    core::Weight weight;
    weight.radius = 0.015 + 0.03 * share();
    weight.mass = 0.19 * std::pow(weight.radius / 0.02, 3);
    const double x = (column + 0.5) * kCell + 0.004 * (share() - 0.5);
    weight.position = {x, (row + 0.5) * kCell + 0.1};
    const double vx = share() - 0.5;
    weight.velocity = {vx, share() - 0.5};
    scene->weights.push_back(weight);
  }
  return scene;
}

double largestOverlap(std::vector<PlacedDisc> discs) {
  double widest = 0;
  Eigen::AlignedBox2d bounds;
  for (const PlacedDisc& disc : discs) {
    widest = std::max(widest, disc.radius);
    bounds.extend(disc.center);
  }
  // Along the longer side fewest are beside each other.
  const int along = bounds.sizes().x() > bounds.sizes().y() ? 0 : 1;
  std::ranges::sort(discs, {}, [along](const PlacedDisc& disc) { return disc.center[along]; });
  double largest = 0;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      const Eigen::Vector2d apart = discs[j].center - discs[i].center;
      if (apart[along] >= discs[i].radius + widest) break;
      largest = std::max(largest, discs[i].radius + discs[j].radius - apart.norm());
    }
  return largest;
}

double largestOverlap(const core::Run& run) {
  std::vector<PlacedDisc> discs;
  for (int i = 0; i < run.weightCount(); ++i)
    discs.push_back({run.weight(i).position, run.scene().weights[i].radius});
  return largestOverlap(std::move(discs));
}

HeapFigures runHeap(const std::shared_ptr<const core::Scene>& scene, const core::Solver& solver,
                    double duration) {
  core::Run run(scene, solver);
  HeapFigures figures;
  while (run.time() < duration) {
    if (run.advance() != core::RunStatus::kRunning) {
      figures.finished = false;
      break;
    }
    figures.overlap = std::max(figures.overlap, largestOverlap(run));
    const core::Energies energies = run.energies();
    figures.highestEnergy =
        std::max(figures.highestEnergy, energies.mechanical() / run.startEnergy());
    const double drift = energies.numericalDrift / run.startEnergy();
    figures.largestGain = std::max(figures.largestGain, drift - figures.drift);
    figures.drift = drift;
    figures.mostEvents = std::max(figures.mostEvents, run.stepEvents().size());
  }
  figures.kinetic = run.energies().kinetic;
  return figures;
}

}  // namespace tests
