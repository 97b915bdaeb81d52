#include "ui/view/ruler.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <QLocale>

namespace ui {

namespace {

double roundSpacing(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    // A hair of room for 10^n that is not exact.
    if (digit * power >= least * (1 - 1e-12)) return digit * power;
  return 10 * power;
}

}  // namespace

Ruler rulerFor(double leastSpacing, double extent) {
  assert(leastSpacing > 0 && extent > 0);
  const double spacing = roundSpacing(leastSpacing);
  if (extent < 0.05) return {spacing, 1e-3, QStringLiteral("mm")};
  if (extent < 1) return {spacing, 1e-2, QStringLiteral("cm")};
  if (extent < 5000) return {spacing, 1, QStringLiteral("m")};
  return {spacing, 1e3, QStringLiteral("km")};
}

QString Ruler::textAt(double metres) const {
  const double steps = std::round(metres / spacing);
  const double needed = std::ceil(-std::log10(spacing / unit) - 1e-9);
  const int decimals = steps == 0 ? 0 : std::max(static_cast<int>(needed), 0);
  // Adding zero turns −0 into 0.
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const QString digits = locale.toString(steps * spacing / unit + 0.0, 'f', decimals);
  return digits + QStringLiteral("\u00a0") + unitName;
}

int partsOf(const Ruler& ruler) {
  const double power = std::pow(10.0, std::floor(std::log10(ruler.spacing) + 1e-9));
  return std::lround(ruler.spacing / power) == 2 ? 4 : 5;
}

}  // namespace ui
