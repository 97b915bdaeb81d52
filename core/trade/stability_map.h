#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/trade/boundedness.h"
#include "core/trade/work_meter.h"

namespace core {

/// What a stability map changes besides the step.
enum class MapQuantity : std::uint8_t {
  kRopeLength,  ///< of the longest rope [m]; all others in proportion
  kAirDensity,  ///< [kg/m³]
};

/// What becomes of a scene, over step × one quantity of the scene.
struct StabilityMap {
  const Method* method = nullptr;
  MapQuantity quantity = MapQuantity::kRopeLength;
  double until = 0;            ///< simulated time of each run [s]
  std::vector<double> steps;   ///< rising [s]
  std::vector<double> values;  ///< of the quantity, rising, in its SI unit
  /// One for each step of each value, value by value; nothing where such a scene cannot be.
  std::vector<std::optional<BoundednessTrial>> cells;

  const std::optional<BoundednessTrial>& cell(std::size_t step, std::size_t value) const {
    return cells[value * steps.size() + step];
  }
};

/// Whether the quantity can be changed: a scene without ropes has no rope length.
bool canBeMapped(const Scene& scene, MapQuantity quantity);

/// The scene with another value of the quantity.
/// @pre canBeMapped(scene, quantity)
Scene withQuantity(Scene scene, MapQuantity quantity, double value);

/// Runs the scene once for each cell, in two threads.
///
/// Steps go from 1/1024 to 1 s; rope lengths from a 64th to four times the present one, air
/// densities from 0.1 to 2000 kg/m³; each the square root of 2 (for air: 2) times the one before.
///
/// @param until     [s], > 0
/// @param progress  may be empty
/// @return          nothing if the progress stopped it
/// @pre problemsIn(scene) is empty; canBeMapped(scene, quantity); the method takes a step
std::optional<StabilityMap> stabilityMap(const Scene& scene, const Method& method,
                                         MapQuantity quantity, double until,
                                         const Progress& progress = {});

}  // namespace core
