#pragma once

#include <vector>

#include "ui/chart/chart_content.h"

namespace core {
struct MotionSample;
}

namespace ui {

/// One curve for each chosen weight in each run. A weight alone is drawn in its runs' colors,
/// several in their own as in the scene.
///
/// @param read  the point of a curve that a sample gives; not finite where there is none
std::vector<ChartCurve> weightCurves(const ChartSubject& subject, const Theme& theme,
                                     core::TimedPoint (*read)(const core::MotionSample&));

/// Content with such curves, and a note if not all chosen weights can be told apart.
ChartContent weightChart(const ChartSubject& subject, const Theme& theme, ChartAxis horizontal,
                         ChartAxis vertical, core::TimedPoint (*read)(const core::MotionSample&));

/// The time axis of charts of weights.
ChartAxis timeAxis();

/// "Weight 3" for index 2.
QString weightName(int index);

}  // namespace ui
