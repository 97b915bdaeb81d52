#pragma once

#include <vector>

#include <QString>

namespace ui {

/// A logarithmic axis, in powers of ten: a value v stands at log10(v).
struct LogScale {
  struct Tick {
    double place;
    QString label;
  };

  double lowest = 0;
  double highest = 1;
  std::vector<Tick> ticks;  ///< rising, within the ends
};

/// Just around both values, labelled at powers of ten as quantities with the prefixes of the SI:
/// "1 mm", "10 mm". Where not all powers have room, every third or sixth is labelled, those
/// without another digit first.
///
/// @param symbol  of the unit without prefix
/// @param most    most labels that have room, ≥ 2
/// @pre 0 < lowest ≤ highest
LogScale decadeScale(double lowest, double highest, const QString& symbol, int most);

/// Just around both values [s], labelled as the parts of a second that computers count in: "1/64
/// s".
/// @pre 0 < lowest ≤ highest
LogScale stepScale(double lowest, double highest, int most);

/// A quantity in two digits, with the prefix from f to m that leaves it one to three before the
/// point: "20 µs", "1.5 mm", "120 m".
/// @pre value > 0
QString prefixedText(double value, const QString& symbol);

}  // namespace ui
