#include "ui/chart/figure_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QLocale>

namespace ui {

namespace {

constexpr double kLeastPlain = 1e-3;
constexpr double kMostPlain = 1e5;
const QString kMinus = QStringLiteral("−");

QString superscript(int exponent) {
  static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString raised;
  for (const QChar digit : QString::number(std::abs(exponent))) {
    raised += kDigits[digit.digitValue()];
  }
  return exponent < 0 ? QStringLiteral("⁻") + raised : raised;
}

QString plainText(double magnitude) {
  const int power = static_cast<int>(std::floor(std::log10(magnitude)));
  return QLocale().toString(magnitude, 'f', std::max(0, 2 - power));
}

QString powerText(double magnitude) {
  int power = static_cast<int>(std::floor(std::log10(magnitude)));
  // In two factors, for 10^power alone is zero below the smallest normal number.
  double mantissa = magnitude / std::pow(10.0, power / 2) / std::pow(10.0, power - power / 2);
  if (mantissa >= 9.95) {
    mantissa = 1;
    ++power;
  }
  return QLocale().toString(mantissa, 'f', 1) + QStringLiteral("·10") + superscript(power);
}

QString magnitudeText(double magnitude) {
  if (magnitude == 0) return QStringLiteral("0");
  if (!std::isfinite(magnitude)) return QStringLiteral("∞");
  const bool plain = kLeastPlain <= magnitude && magnitude < kMostPlain;
  return plain ? plainText(magnitude) : powerText(magnitude);
}

}  // namespace

ScaledUnit scaledUnit(double highest, const QString& symbol) {
  if (!(highest > 0) || (0.1 <= highest && highest < 1e4)) return {1, symbol};

  static const std::array<const char*, 10> kPrefixes = {"n", "µ", "m", "",  "k",
                                                        "M", "G", "T", "P", "E"};
  constexpr int kUnprefixed = 3;
  const int thousands = static_cast<int>(std::floor(std::log10(highest) / 3 + 1e-9));
  const int last = static_cast<int>(kPrefixes.size()) - 1;
  const int index = std::clamp(thousands + kUnprefixed, 0, last);
  return {std::pow(1000.0, index - kUnprefixed), QString::fromUtf8(kPrefixes[index]) + symbol};
}

QString figure(double value) {
  return (value < 0 ? kMinus : QString()) + magnitudeText(std::abs(value));
}

QString signedFigure(double value) {
  return (value > 0 ? QStringLiteral("+") : QString()) + figure(value);
}

QString widestFigure() {
  return signedFigure(-8.8e-16);
}

}  // namespace ui
