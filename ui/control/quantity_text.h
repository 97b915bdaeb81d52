#pragma once

#include <optional>

#include <QString>

#include "core/scene/scene_limits.h"

namespace ui {

/// A number as a person types it: plain, with exponent, or a fraction such as 1/240; point
/// or comma before the decimals; the unit may follow.
///
/// @return  nothing if the text is anything else, or not finite
std::optional<double> parsedQuantity(const QString& text, const QString& unit);

/// A number as the reader writes it, in at most 12 digits, so that a converted angle reads
/// 70 and not 70.00000000000001.
QString quantityText(double value);

/// The same, but one part of a whole as a fraction: 1/240.
QString fractionText(double value);

/// "from 0 to 1000 m/s²".
QString rangeText(const core::Range& range);

}  // namespace ui
