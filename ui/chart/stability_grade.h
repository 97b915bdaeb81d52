#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <QColor>
#include <QString>

#include "core/trade/boundedness.h"

namespace ui {

/// What a cell of a stability map is colored by.
enum class StabilityGrade : std::uint8_t { kExact, kFair, kPoor, kRunaway, kDiverged };

inline constexpr std::array kStabilityGrades{StabilityGrade::kExact, StabilityGrade::kFair,
                                             StabilityGrade::kPoor, StabilityGrade::kRunaway,
                                             StabilityGrade::kDiverged};

StabilityGrade gradeOf(const core::BoundednessTrial& trial);

/// The same in light and dark windows; the worse the darker, so that it can be told without
/// seeing hues.
QColor colorOf(StabilityGrade grade);

/// For a legend: "drift under 1 %".
QString wordsFor(StabilityGrade grade);

}  // namespace ui
