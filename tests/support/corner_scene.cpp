#include "tests/support/corner_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/run/run.h"
#include "core/scene/scene_limits.h"
#include "tests/support/processor_time.h"
#include "tests/support/run_watch.h"

namespace tests {
namespace {

using core::Range;
using core::Rope;
using core::Weight;

/// Reads one choice after another from the bits of a number.
class Choices {
 public:
  explicit Choices(int bits) : m_bits(bits) {}

  bool next() {
    const bool chosen = (m_bits & 1) != 0;
    m_bits >>= 1;
    return chosen;
  }
  double endOf(const Range& range) { return next() ? range.highest : range.lowest; }

 private:
  int m_bits;
};

constexpr double kLongest = 60;  // [s] of processor time

}  // namespace

core::Scene cornerScene(int corner) {
  Choices choices(corner);
  core::Scene scene;
  scene.gravity = choices.endOf(core::kGravityRange);
  scene.airDensity = choices.endOf(core::kAirDensityRange);
  const double size = choices.endOf(core::kRoomSizeRange);
  scene.room.width = scene.room.height = size;
  scene.room.restitution = choices.endOf(core::kRestitutionRange);
  scene.restitution = choices.endOf(core::kRestitutionRange);
  scene.room.friction = choices.endOf(core::kFrictionRange);
  Weight model;
  model.mass = choices.endOf(core::kMassRange);
  model.radius = std::min(choices.endOf(core::kRadiusRange), 0.04 * size);
  model.dragCoefficient = choices.endOf(core::kDragCoefficientRange);
  const double length = std::min(choices.endOf(core::kRopeLengthRange), 0.1 * size);
  const bool fast = choices.next();
  const double turning = fast ? core::kAngularVelocityRange.highest / 180 * std::numbers::pi : 0;
  const double speed = fast ? core::kVelocityRange.highest : 0;
  if (choices.next()) scene.cutTime = 0.6e-6;

  Weight onRope = model, onRod = model, fromWest = model, fromEast = model, lying = model,
         falling = model;
  onRope.rope = Rope{
      .pivot = {0.25 * size, 0.8 * size}, .length = length, .angle = 1, .angularVelocity = turning};
  onRod.rope = Rope{.pivot = {0.75 * size, 0.8 * size},
                    .length = length,
                    .angle = std::numbers::pi,
                    .angularVelocity = -turning,
                    .rigid = true};
  fromWest.position = {0.3 * size, 0.45 * size};
  fromWest.velocity = {speed, 0};
  fromEast.position = {0.7 * size, 0.45 * size};
  fromEast.velocity = {-speed, 0};
  lying.position = {0.5 * size, model.radius};
  lying.velocity = {0.5 * speed, 0};
  falling.mass = core::kMassRange.highest;
  falling.position = {0.5 * size + 0.3 * model.radius, 0.2 * size};
  scene.weights = {onRope, onRod, fromWest, fromEast, lying, falling};
  return scene;
}

std::string faultAtCorner(int corner, const core::Solver& solver, int steps) {
  const auto scene = std::make_shared<const core::Scene>(cornerScene(corner));
  const std::vector<core::Problem> problems = core::problemsIn(*scene);
  if (!problems.empty()) return problems.front().place + " is not allowed";
  const double start = processorTime();
  core::Run run(scene, solver);
  for (int i = 0; i < steps && run.advance() == core::RunStatus::kRunning; ++i)
    if (processorTime() - start > kLongest) return "takes too long";
  if (!isFinite(run)) return "numbers that are not finite";
  const Bounds bounds = Bounds::extreme(scene->room);
  const double outside = farthestOutside(run, bounds);
  if (outside > bounds.outside) return core::numberText(outside) + " m outside the room";
  const double overlap = deepestOverlap(run, bounds);
  if (overlap > 0) return core::numberText(overlap) + " m of overlap too much";
  return {};
}

}  // namespace tests
