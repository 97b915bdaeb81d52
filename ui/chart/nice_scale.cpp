#include "ui/chart/nice_scale.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ui {

namespace {

// A value that reaches a tick but for rounding needs no further step.
constexpr double kRounding = 1e-9;

double niceStep(double atLeast) {
  const double power = std::pow(10.0, std::floor(std::log10(atLeast)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (atLeast <= factor * power * (1 + kRounding)) return factor * power;
  }
  return 10 * power;
}

}  // namespace

int NiceScale::tickCount() const {
  return static_cast<int>(std::lround((highest - lowest) / step)) + 1;
}

int NiceScale::decimals() const {
  return std::max(0, static_cast<int>(-std::floor(std::log10(step) + kRounding)));
}

NiceScale niceScale(double lowest, double highest, int intervals) {
  assert(lowest <= highest && intervals >= 1);
  if (lowest == highest) highest = lowest + 1;

  const double step = niceStep((highest - lowest) / intervals);
  return {step * std::floor(lowest / step + kRounding),
          step * std::ceil(highest / step - kRounding), step};
}

}  // namespace ui
