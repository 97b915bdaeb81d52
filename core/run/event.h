#pragma once

#include <cstdint>
#include <string_view>

#include <Eigen/Core>

namespace core {

enum class EventKind : std::uint8_t {
  kCut,
  kTurningPoint,
  kSlack,
  kTaut,
  kImpactFloor,
  kImpactCeiling,
  kImpactWest,
  kImpactEast,
  kImpactWeight,
  kRest,
};

/// The word that stands for the kind in files: "turning-point", "impact-floor".
std::string_view nameOf(EventKind kind);

/// Something that happened at one moment of a run.
struct Event {
  double time = 0;  ///< [s]
  EventKind kind = EventKind::kCut;
  int weight = -1;                 ///< index, the lower of two; −1 for a cut of all ropes
  int other = -1;                  ///< index of the second weight of kImpactWeight, else −1
  Eigen::Vector2d position{0, 0};  ///< of `weight`'s center [m]; unused for a cut of all ropes
  double energyLost = 0;           ///< [J], ≥ 0
  double speedBefore = 0;          ///< of `weight` [m/s]
  double speedAfter = 0;           ///< of `weight` [m/s]
};

}  // namespace core
