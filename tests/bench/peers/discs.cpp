#include "tests/bench/peers/discs.h"

#include <utility>
#include <vector>

#include "core/run/run.h"
#include "tests/support/heap.h"

namespace bench {
namespace {

class OurWorld : public DiscWorld {
 public:
  OurWorld(const core::Scene& scene, const WorldOptions& options)
      : m_run(std::make_shared<const core::Scene>(scene), {.method = "rk4", .step = options.step}) {
  }

  bool step() override {
    const bool runs = m_run.advance() == core::RunStatus::kRunning;
    for (const core::Event& event : m_run.stepEvents())
      if (core::EventKind::kImpactFloor <= event.kind &&
          event.kind <= core::EventKind::kImpactWeight)
        ++m_impacts;
    return runs;
  }
  Eigen::Vector2d position(int disc) const override { return m_run.weight(disc).position; }
  Eigen::Vector2d velocity(int disc) const override { return m_run.weight(disc).velocity; }
  int impacts() const override { return m_impacts; }

 private:
  core::Run m_run;
  int m_impacts = 0;
};

}  // namespace

std::unique_ptr<DiscWorld> ourWorld(const core::Scene& scene, const WorldOptions& options) {
  return std::make_unique<OurWorld>(scene, options);
}

std::vector<Engine> otherEngines() {
  std::vector<Engine> engines;
#ifdef BENCH_BOX2D
  engines.push_back({"Box2D", box2dWorld});
#endif
#ifdef BENCH_CHIPMUNK
  engines.push_back({"Chipmunk", chipmunkWorld});
#endif
  return engines;
}

std::vector<Engine> crowdEngines() {
  std::vector<Engine> engines{{"Angry Cuts", ourWorld}};
  for (const Engine& engine : otherEngines()) engines.push_back(engine);
#ifdef BENCH_CHIPMUNK
  engines.push_back({"Chipmunk, spatial hash", chipmunkWorld, {.isHashed = true}});
  engines.push_back({"Chipmunk, slop 10 µm", chipmunkWorld, {.slop = 1e-5}});
#endif
  return engines;
}

double largestOverlap(const core::Scene& scene, const DiscWorld& world) {
  std::vector<tests::PlacedDisc> discs;
  for (std::size_t i = 0; i < scene.weights.size(); ++i)
    discs.push_back({world.position(static_cast<int>(i)), scene.weights[i].radius});
  return tests::largestOverlap(std::move(discs));
}

double kineticEnergy(const core::Scene& scene, const DiscWorld& world) {
  double sum = 0;
  for (std::size_t i = 0; i < scene.weights.size(); ++i)
    sum += scene.weights[i].mass * world.velocity(static_cast<int>(i)).squaredNorm() / 2;
  return sum;
}

}  // namespace bench
