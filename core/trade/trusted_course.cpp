#include "core/trade/trusted_course.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/run/run.h"
#include "core/trade/reference.h"

namespace core {
namespace {

constexpr double kLookedAt = 1.0 / 8;  // [s]; places in between are as exact

/// The scene with every speed and rope's angle changed in the last digit, one weight's up and
/// the next one's down.
std::shared_ptr<const Scene> nudged(Scene scene) {
  double factor = 1 + std::numeric_limits<double>::epsilon();
  for (Weight& weight : scene.weights) {
    weight.velocity *= factor;
    if (weight.rope) {
      weight.rope->angle *= factor;
      weight.rope->angularVelocity *= factor;
    }
    factor = 2 - factor;
  }
  return std::make_shared<const Scene>(std::move(scene));
}

/// The reference solution, from one sample to the next.
class SampledReference {
 public:
  SampledReference(const std::shared_ptr<const Scene>& scene, double tolerance)
      : m_run(scene, referenceSolver(kLookedAt, tolerance)), m_positions(scene->weights.size()) {}

  /// @return  false if it cannot get there
  bool reach(double time) {
    while (m_run.time() < time) {
      if (m_run.advance() != RunStatus::kRunning) return false;
    }
    for (int i = 0; i < m_run.weightCount(); ++i) m_positions[i] = m_run.weightAt(i, time).position;
    return true;
  }

  std::span<const Eigen::Vector2d> positions() const { return m_positions; }

 private:
  Run m_run;
  std::vector<Eigen::Vector2d> m_positions;
};

}  // namespace

std::optional<TrustedCourse> trustedCourse(const std::shared_ptr<const Scene>& scene, double until,
                                           const Progress& progress) {
  const int weightCount = static_cast<int>(scene->weights.size());
  TrustedCourse trusted{SampleTimes(until, weightCount), SampledCourse(weightCount)};
  SampledReference fine(scene, kReferenceTolerance);
  SampledReference coarse(nudged(*scene), kCoarseReferenceTolerance);
  for (int i = 0; i < trusted.times.count(); ++i) {
    const double time = trusted.times.at(i);
    if (!fine.reach(time) || !coarse.reach(time)) break;
    const double distance = largestDistance(fine.positions(), coarse.positions());
    if (!(distance <= kTrustedAgreement)) break;
    trusted.uncertainty = std::max(trusted.uncertainty, distance);
    trusted.course.append(fine.positions());
    if (progress && !progress((i + 1.0) / trusted.times.count())) return std::nullopt;
  }
  return trusted;
}

}  // namespace core
