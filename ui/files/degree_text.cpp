#include "ui/files/degree_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <sstream>
#include <string>
#include <system_error>

#include "core/scene/angle.h"
#include "core/scene/scene_limits.h"

namespace ui {

namespace {

constexpr std::size_t kLongestDouble = std::numeric_limits<double>::max_digits10;

/// Reads one number and nothing else; false where the text is something else.
template <class Number>
bool read(std::string_view text, Number& number) {
#ifdef __cpp_lib_to_chars
  const char* textEnd = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), textEnd, number);
  return error == std::errc() && end == textEnd;
#else  // Clang's library on macOS has it for whole numbers only.
  if (text.find_first_not_of("0123456789+-.eE") != text.npos || text.starts_with('+')) return false;
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  return stream >> number && stream.peek() == std::istringstream::traits_type::eof();
#endif
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number number = 0;
  if (!read(text, number) || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

std::optional<double> numberFromText(std::string_view text) {
  return parsed<double>(text);
}

double radiansFromDegreeText(std::string_view text) {
  if (text.size() <= kLongestDouble) return core::radians(*parsed<double>(text));
  constexpr long double kRadiansPerDegree = std::numbers::pi_v<long double> / 180;
  return static_cast<double>(*parsed<long double>(text) * kRadiansPerDegree);
}

std::string degreeText(double radians) {
  std::string text = core::numberText(core::degrees(radians));
  if (radiansFromDegreeText(text) == radians) return text;

  constexpr long double kDegreesPerRadian = 180 / std::numbers::pi_v<long double>;
  std::array<char, 64> digits;
  const auto [end, error] =
      std::to_chars(digits.begin(), digits.end(), radians * kDegreesPerRadian,
                    std::chars_format::general, std::numeric_limits<long double>::max_digits10);
  return {digits.begin(), end};
}

}  // namespace ui
