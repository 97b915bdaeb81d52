#include "ui/chart/log_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

namespace ui {
namespace {

// A value that is a power of ten but for rounding is one.
constexpr double kRounding = 1e-9;
constexpr double kLog10Of2 = 0.30102999566398119521;
// Beyond the ends, so that no mark is cut; and at least so far that there is a tick or two.
constexpr double kMargin = 0.04;  // of the axis
constexpr double kLeastLength = 1.2;

LogScale around(double lowest, double highest) {
  const double first = std::log10(lowest), last = std::log10(highest);
  const double length = std::max(kLeastLength, (1 + 2 * kMargin) * (last - first));
  const double middle = (first + last) / 2;
  return {middle - length / 2, middle + length / 2, {}};
}

QString stepLabel(int power) {
  const double count = std::exp2(std::abs(power));
  const QString text = QString::number(count, 'f', 0);
  const auto translated = [](const char* words) {
    return QCoreApplication::translate("ui::LogScale", words);
  };
  return power < 0 ? translated(QT_TRANSLATE_NOOP("ui::LogScale", "1/%1 s")).arg(text)
                   : translated(QT_TRANSLATE_NOOP("ui::LogScale", "%1 s")).arg(text);
}

}  // namespace

QString prefixedText(double value, const QString& symbol) {
  static const std::array<const char*, 5> kPrefixes = {"f", "p", "n", "µ", "m"};
  const double digit = std::pow(10, std::floor(std::log10(value) + kRounding) - 1);
  const double rounded = std::round(value / digit) * digit;
  const int thousands = static_cast<int>(std::floor(std::log10(rounded) / 3 + kRounding));
  const int index = std::max(0, thousands + static_cast<int>(kPrefixes.size()));
  const bool isWhole = thousands >= 0;
  const double size = isWhole ? 1 : std::pow(1000.0, index - static_cast<int>(kPrefixes.size()));
  const QString prefix = isWhole ? QString() : QString::fromUtf8(kPrefixes[index]);
  // Six digits, so that no exponent appears below a million.
  return QLocale().toString(rounded / size, 'g', 6) + QChar(QChar::Nbsp) + prefix + symbol;
}

LogScale decadeScale(double lowest, double highest, const QString& symbol, int most) {
  LogScale scale = around(lowest, highest);
  const int first = static_cast<int>(std::ceil(scale.lowest));
  const int last = static_cast<int>(std::floor(scale.highest));
  int stride = 1;
  while ((last - first) / stride + 1 > most) stride = stride == 1 ? 3 : stride + 3;
  for (int power = first; power <= last; ++power) {
    if (power % stride != 0) continue;
    scale.ticks.push_back(
        {static_cast<double>(power), prefixedText(std::pow(10.0, power), symbol)});
  }
  return scale;
}

LogScale stepScale(double lowest, double highest, int most) {
  LogScale scale = around(lowest, highest);
  const int first = static_cast<int>(std::ceil(scale.lowest / kLog10Of2));
  const int last = static_cast<int>(std::floor(scale.highest / kLog10Of2));
  int stride = 1;
  while ((last - first) / stride + 1 > most) ++stride;
  for (int power = first; power <= last; ++power) {
    if (power % stride == 0) scale.ticks.push_back({power * kLog10Of2, stepLabel(power)});
  }
  return scale;
}

}  // namespace ui
