#pragma once

#include <array>
#include <tuple>
#include <utility>

#include "core/methods/dormand_prince.h"
#include "core/methods/explicit_euler.h"
#include "core/methods/rk4.h"
#include "core/methods/semi_implicit_euler.h"

namespace core {

/// The unit of every method that is offered, in the order of the table. A new method is one more
/// name here.
using MethodUnits = std::tuple<ExplicitEuler, SemiImplicitEuler, RungeKutta4, DormandPrince>;

inline constexpr auto kMethodTable =
    std::apply([](auto... unit) { return std::array{decltype(unit)::kRow...}; }, MethodUnits{});

/// Calls `use` with the unit of the method at this place of the table, so that its step is
/// compiled into the caller's loop.
///
/// @pre index < methods().size()
template <class Use>
void withMethod(std::size_t index, Use&& use) {
  [&]<std::size_t... kPlace>(std::index_sequence<kPlace...>) {
    ((kPlace == index ? use(std::tuple_element_t<kPlace, MethodUnits>{}) : void()), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<MethodUnits>>{});
}

}  // namespace core
