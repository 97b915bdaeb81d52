#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <QPolygonF>
#include <QRectF>

#include "core/recording/thinning.h"

namespace ui {

/// What of a curve lies in a rectangle, in pieces that each can be drawn in one go, for
/// painters that do not clip. Gaps are left open; where the curve crosses an edge the piece
/// ends just there.
///
/// @param range  in the units of the curve; its top() is the lowest y
/// @param most   points wanted at most, every peak kept
std::vector<QPolygonF> piecesInside(std::span<const core::TimedPoint> curve, const QRectF& range,
                                    std::size_t most);

/// The area between a curve over time and a height, cut in the same way.
std::vector<QPolygonF> areasInside(std::span<const core::TimedPoint> curve, double base,
                                   const QRectF& range, std::size_t most);

/// The part of a curve over time that lies between two moments, and one point more at each
/// end to lead there.
std::span<const core::TimedPoint> partBetween(std::span<const core::TimedPoint> curve, double from,
                                              double to);

/// No curve needs more, on any screen or paper.
inline constexpr std::size_t kMostPointsOfACurve = 2000;

/// Most points for each of several curves that are painted together.
///
/// @param mostForAll  what all of them may have together; bounds the time to paint them
std::size_t mostPointsPerCurve(std::size_t curves, std::size_t mostForAll);

}  // namespace ui
