#pragma once

namespace ui {

/// Ends and ticks of an axis, all on multiples of 1, 2 or 5 times a power of ten, so that
/// labels are short and an axis that follows a growing run grows in steps.
struct NiceScale {
  double lowest = 0;
  double highest = 1;
  double step = 1;

  int tickCount() const;
  /// Digits after the decimal point that every tick label needs.
  int decimals() const;

  bool operator==(const NiceScale&) const = default;
};

/// Smallest nice scale that holds both values.
///
/// @param intervals  most steps wanted, ≥ 1; one more where the ends do not fall on ticks
/// @pre   lowest ≤ highest, both finite; where they are equal the scale is one unit high
NiceScale niceScale(double lowest, double highest, int intervals);

}  // namespace ui
