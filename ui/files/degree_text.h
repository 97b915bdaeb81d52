#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ui {

/// The number these characters stand for, whatever the locale; nothing if they are not one
/// number from end to end or it is too large or too small for a double.
std::optional<double> numberFromText(std::string_view text);

/// The angle written as these digits [°], in [rad].
///
/// Up to 17 characters give core::radians() of the double they stand for, so that a field
/// and a file that both say 70 mean the same angle. Longer texts are converted in
/// extended precision: one in ten doubles of an angle in radians lies between the angles
/// that doubles of degrees can name.
/// @pre numberFromText(text) is something
double radiansFromDegreeText(std::string_view text);

/// A text from which radiansFromDegreeText() gives exactly this angle, short where it was set
/// in degrees.
/// @param radians  finite
std::string degreeText(double radians);

}  // namespace ui
