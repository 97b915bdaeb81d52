#include "core/scene/scene.h"

#include <cmath>

namespace core {

Eigen::Vector2d startPosition(const Weight& weight) {
  if (!weight.rope) return weight.position;
  const Rope& rope = *weight.rope;
  return rope.pivot + rope.length * Eigen::Vector2d(std::sin(rope.angle), -std::cos(rope.angle));
}

Eigen::Vector2d startVelocity(const Weight& weight) {
  if (!weight.rope) return weight.velocity;
  const Rope& rope = *weight.rope;
  return rope.length * rope.angularVelocity *
         Eigen::Vector2d(std::cos(rope.angle), std::sin(rope.angle));
}

}  // namespace core
