#pragma once

#include <QString>

namespace ui {

/// How a length is divided and written along an axis.
struct Ruler {
  double spacing;  ///< between numbers [m]: 1, 2 or 5 times a power of ten
  double unit;     ///< what the numbers count [m]
  QString unitName;

  /// The number nearest to `metres` with its unit, in the reader's number format: "0.5 m".
  QString textAt(double metres) const;
};

/// A ruler with its numbers at least `leastSpacing` [m] apart, in the unit that suits lengths
/// of `extent` [m].
/// @pre both > 0
Ruler rulerFor(double leastSpacing, double extent);

/// How many parts the space between two numbers of this ruler divides into: 5, or 4 where
/// that gives round parts.
int partsOf(const Ruler& ruler);

}  // namespace ui
