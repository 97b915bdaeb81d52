#include "core/trade/reference.h"

#include "core/methods/taylor_series.h"

namespace core {

Solver referenceSolver(double step, double tolerance) {
  return {std::string(TaylorSeries::kRow.id), step, tolerance};
}

bool isReference(const Solver& solver) {
  return solver.method == TaylorSeries::kRow.id;
}

}  // namespace core
