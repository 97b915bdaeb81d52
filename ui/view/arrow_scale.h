#pragma once

namespace core {
struct Scene;
}

namespace ui {

/// Length of the arrow that the legend shows for comparison [px].
inline constexpr double kReferenceLength = 60;

/// What an arrow of kReferenceLength stands for: 1, 2 or 5 times a power of ten.
struct ArrowScales {
  double speed = 1;  ///< [m/s]
  double force = 1;  ///< [N]

  double pixelsPerSpeed() const { return kReferenceLength / speed; }  ///< [px s/m]
  double pixelsPerForce() const { return kReferenceLength / force; }  ///< [px/N]

  bool operator==(const ArrowScales&) const = default;
};

/// Scales that suit the whole course of a scene: the heaviest weight's gravity is about as long
/// as the reference, and so is half the speed of a fall from the ceiling, or of the fastest
/// weight at the start. Where nothing pulls, the largest force at the start decides.
ArrowScales arrowScales(const core::Scene& scene);

}  // namespace ui
