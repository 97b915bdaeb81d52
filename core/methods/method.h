#pragma once

#include <span>
#include <string_view>

namespace core {

/// One row of the method table that menus, tests, measurements and help read.
struct Method {
  std::string_view id;    ///< as in scene files and on the command line
  std::string_view name;  ///< the method's name in English, such as "Runge–Kutta 4"
  int order;              ///< global error O(h^order)
  int slopesPerStep;      ///< slope evaluations of one step
};

/// All methods, simplest first.
std::span<const Method> methods();

/// @return  the method of that id, or null; never owned by the caller
const Method* findMethod(std::string_view id);

}  // namespace core
