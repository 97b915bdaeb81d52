#include "core/methods/method.h"

#include <algorithm>

#include "core/methods/method_list.h"
#include "core/methods/taylor_series.h"

namespace core {

std::span<const Method> methods() {
  return kMethodTable;
}

const Method* findMethod(std::string_view id) {
  return id == TaylorSeries::kRow.id ? &TaylorSeries::kRow : findOfferedMethod(id);
}

const Method* findOfferedMethod(std::string_view id) {
  const auto found = std::ranges::find(kMethodTable, id, &Method::id);
  return found == kMethodTable.end() ? nullptr : &*found;
}

}  // namespace core
