#pragma once

#include <QString>

namespace ui {

/// A unit with the prefix that keeps axis labels short.
struct ScaledUnit {
  double size = 1;  ///< in the unit without prefix: 1000 for kJ
  QString symbol;   ///< "kJ"
};

/// The prefix, from n to E, for an axis that ends at `highest`; none from 0.1 up to 10 000.
ScaledUnit scaledUnit(double highest, const QString& symbol);

/// Two or three significant digits, as a person would write them: "−12.4", "+0.0312",
/// "+3.1·10⁻⁹", "0".
QString signedFigure(double value);
/// The same without a plus sign.
QString figure(double value);

/// The widest text that signedFigure() commonly gives, to keep room for it.
QString widestFigure();

}  // namespace ui
