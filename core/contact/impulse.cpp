#include "core/contact/impulse.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace core {

double CollidingWeight::inverseMass(const Eigen::Vector2d& n) const {
  if (track.isZero(0)) return 1 / mass;
  const double along = track.dot(n);
  return along * along / mass;
}

Eigen::Vector2d CollidingWeight::velocityChange(double impulse, const Eigen::Vector2d& n) const {
  if (track.isZero(0)) return impulse / mass * n;
  return impulse / mass * track.dot(n) * track;
}

double collisionImpulse(const CollidingWeight& a, const CollidingWeight& b,
                        const Eigen::Vector2d& normal, double restitution) {
  assert(std::abs(normal.norm() - 1) < 1e-9);
  const double approachSpeed = (a.velocity - b.velocity).dot(normal);
  const double inverseMass = a.inverseMass(normal) + b.inverseMass(normal);
  if (approachSpeed <= 0 || inverseMass <= 0) return 0;
  return (1 + restitution) * approachSpeed / inverseMass;
}

double collisionLoss(const CollidingWeight& a, const CollidingWeight& b,
                     const Eigen::Vector2d& normal, double restitution) {
  const double approachSpeed = (a.velocity - b.velocity).dot(normal);
  const double inverseMass = a.inverseMass(normal) + b.inverseMass(normal);
  if (approachSpeed <= 0 || inverseMass <= 0) return 0;
  return 0.5 * (1 - restitution * restitution) * approachSpeed * approachSpeed / inverseMass;
}

WallImpact wallImpact(const Eigen::Vector2d& velocity, double mass, const Eigen::Vector2d& inward,
                      double restitution, double friction) {
  assert(std::abs(inward.norm() - 1) < 1e-9);
  const double approachSpeed = -velocity.dot(inward);
  if (approachSpeed <= 0) return {velocity, 0};
  const Eigen::Vector2d along(-inward.y(), inward.x());
  const double slip = velocity.dot(along);
  const double braking = std::min(friction * (1 + restitution) * approachSpeed, std::abs(slip));
  const double slipAfter = slip - std::copysign(braking, slip);
  const Eigen::Vector2d after = restitution * approachSpeed * inward + slipAfter * along;
  // (slip − slipAfter)(slip + slipAfter) keeps the digits a difference of squares would lose.
  const double lost = 0.5 * mass *
                      ((1 - restitution) * (1 + restitution) * approachSpeed * approachSpeed +
                       (slip - slipAfter) * (slip + slipAfter));
  return {after, lost};
}

}  // namespace core
