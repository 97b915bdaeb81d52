#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace core {

/// How a weight moves between the two ends of a step.
enum class PathShape : std::uint8_t {
  kStraight,    ///< every entry of the state changes evenly, which is what Euler's method says
  kParabola,    ///< through both ends with the slope at the start
  kCubic,       ///< the cubic through both ends with both slopes (Hermite)
  kQuartic,     ///< that cubic and a bulge of degree 4, the method's continuous extension
  kPolynomial,  ///< the method's own polynomial: a step to a moment in it is read from it
};

/// One row of the method table that menus, tests, measurements and help read.
struct Method {
  std::string_view id;    ///< as in scene files and on the command line
  std::string_view name;  ///< the method's name in English, such as "Runge–Kutta 4"
  int order;              ///< global error O(h^order)
  int slopesPerStep;      ///< slope evaluations of one step
  PathShape path;
  /// Takes a tolerance and chooses its own steps, different ones for every weight; else it
  /// takes the step it is given.
  bool isAdaptive = false;
  /// Users may choose it; else it is for the program's own use.
  bool isOffered = true;

  /// Whether a kink inside a step would cost the method its order, so that steps are split
  /// there.
  bool mindsKinks() const { return order > 2; }
};

/// All methods that are offered, simplest first.
std::span<const Method> methods();

/// @return  the method of that id, offered or not, or null; never owned by the caller
const Method* findMethod(std::string_view id);

/// @return  the same, but null as well for those that are not offered: what users may name
const Method* findOfferedMethod(std::string_view id);

}  // namespace core
