#pragma once

#include <cstddef>
#include <vector>

#include <QList>
#include <QPointF>

#include "core/recording/thinning.h"

namespace ui {

/// What of a curve lies between two heights, for painters that do not clip.
///
/// Stretches above or below run along the limit; before the curve first comes inside and
/// after it last leaves nothing is drawn. Crossings are put in where it enters and leaves.
///
/// @pre lowest < highest
QList<QPointF> cutToScale(const std::vector<core::CurvePoint>& curve, double lowest,
                          double highest);

/// No curve needs more, on any screen or paper.
inline constexpr std::size_t kMostPointsOfACurve = 2000;

/// Most points for each of several curves that are painted together.
///
/// @param mostForAll  what all of them may have together; bounds the time to paint them
std::size_t mostPointsPerCurve(std::size_t curves, std::size_t mostForAll);

}  // namespace ui
