#include "ui/files/degree_text.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <system_error>

#include <QtMath>

#include "core/scene/scene_limits.h"

namespace ui {

namespace {

constexpr std::size_t kLongestDouble = std::numeric_limits<double>::max_digits10;

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number = 0;
  const char* textEnd = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), textEnd, number);
  if (error != std::errc() || end != textEnd || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string textOf(long double number, int digits) {
  char text[64];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits);
  return {text, end};
}

}  // namespace

std::optional<double> numberFromText(std::string_view text) {
  return parsed<double>(text);
}

double radiansFromDegreeText(std::string_view text) {
  if (text.size() <= kLongestDouble) return qDegreesToRadians(*parsed<double>(text));
  constexpr long double kRadiansPerDegree = std::numbers::pi_v<long double> / 180;
  return static_cast<double>(*parsed<long double>(text) * kRadiansPerDegree);
}

std::string degreeText(double radians) {
  // Most angles were set in degrees: the first digits that lead back are the ones set.
  const double nearest = qRadiansToDegrees(radians);
  for (const int digits : {6, 10, 15, 16, 17}) {
    const double rounded = parsed<double>(textOf(nearest, digits)).value_or(nearest);
    std::string text = core::numberText(rounded);
    if (radiansFromDegreeText(text) == radians) return text;
  }
  constexpr long double kDegreesPerRadian = 180 / std::numbers::pi_v<long double>;
  return textOf(radians * kDegreesPerRadian, std::numeric_limits<long double>::max_digits10);
}

}  // namespace ui
