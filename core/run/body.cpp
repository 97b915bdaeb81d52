#include "core/run/body.h"

#include "core/motion/drag.h"

namespace core {

std::vector<Body> bodiesOf(const Scene& scene) {
  std::vector<Body> bodies;
  bodies.reserve(scene.weights.size());
  for (const Weight& weight : scene.weights) {
    const Rope rope = weight.rope.value_or(Rope{});
    bodies.push_back({weight.mass, weight.radius, dragFactor(weight, scene.airDensity),
                      weight.rope.has_value(), rope.rigid, rope.length, rope.pivot});
  }
  return bodies;
}

}  // namespace core
