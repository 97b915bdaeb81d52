#pragma once

#include <vector>

#include <QString>

namespace tests {

/// A number that a teacher's sheet quotes, worked out anew.
struct LessonFigure {
  const char* what;
  double value;
  int decimals;      ///< kFraction, kPower or how many it is quoted with
  const char* unit;  ///< "" if it has none

  static constexpr int kFraction = -1;  ///< quoted as 1/60, of the value 60
  static constexpr int kPower = -2;     ///< quoted as the window does: 9.2·10⁻⁵

  /// As it is written in the default locale, without its unit.
  QString text() const;
};

/// Every number that a lesson's sheet gives for what the class will see, by the lesson's scene.
std::vector<LessonFigure> lessonFigures(const QString& lesson);

}  // namespace tests
