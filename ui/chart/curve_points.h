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

/// Most points for each of several curves that are painted together, so that the whole
/// chart can be painted 30 times a second beside the scene.
std::size_t mostPointsPerCurve(std::size_t curves);

}  // namespace ui
