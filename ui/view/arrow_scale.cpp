#include "ui/view/arrow_scale.h"

#include <algorithm>
#include <cmath>

#include "core/motion/forces.h"
#include "core/scene/scene.h"

namespace ui {

namespace {

/// The largest of 1, 2 and 5 times a power of ten up to `value`; 1 for zero.
double roundBelow(double value) {
  if (!(value > 0)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    // A hair of room for 10^n that is not exact.
    if (digit * power <= value * (1 + 1e-12)) return digit * power;
  return power;
}

/// What the rope needs besides to keep the weight on its circle, and what the air does [N].
double forceOfMotion(const core::Weight& weight, double airDensity) {
  const double speed = core::startVelocity(weight).norm();
  const double turning = weight.rope ? weight.mass * speed * speed / weight.rope->length : 0;
  return std::max(turning, core::dragOn(weight, airDensity, {speed, 0}).norm());
}

}  // namespace

ArrowScales arrowScales(const core::Scene& scene) {
  double fastest = 0, heaviest = 0, strongest = 0;
  for (const core::Weight& weight : scene.weights) {
    fastest = std::max(fastest, core::startVelocity(weight).norm());
    heaviest = std::max(heaviest, core::gravityOn(weight, scene.gravity).norm());
    strongest = std::max(strongest, forceOfMotion(weight, scene.airDensity));
  }
  const double fall = std::sqrt(scene.gravity * scene.room.height);
  return {roundBelow(std::max(fall, fastest) / 2),
          roundBelow(1.5 * (heaviest > 0 ? heaviest : strongest))};
}

}  // namespace ui
