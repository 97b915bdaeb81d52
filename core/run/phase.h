#pragma once

#include <cstdint>
#include <string_view>

namespace core {

/// What a weight is doing.
enum class Phase : std::uint8_t {
  kTethered,  ///< swings on a taut rope or a rod
  kSlack,     ///< flies inside the circle of its slack rope
  kFlying,    ///< flies free
  kResting,   ///< in lasting contact with a surface or other weights; may slide
};

/// The word that stands for the phase in files: "tethered".
std::string_view nameOf(Phase phase);

}  // namespace core
