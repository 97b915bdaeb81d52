#pragma once

#include <vector>

#include "ui/chart/chart_content.h"
#include "ui/chart/chart_heading.h"
#include "ui/chart/hidden_curves.h"

namespace ui {

struct AxisScale;
struct EnergyExtent;

/// Names for a legend, each once, in the order of the curves; empty where they are too many to
/// be told apart, or there is only one.
std::vector<const ChartCurve*> legendCurves(const std::vector<ChartCurve>& curves);

/// Legend and runs; of energies also their drift in figures, and a warning where curves
/// leave the scale.
///
/// @param shown  which curves have anything to show
HeadingContent plotHeading(const ChartSubject& subject, const ChartContent& content,
                           const std::vector<bool>& shown, const HiddenCurves& hidden,
                           const EnergyExtent& extent, const AxisScale& vertical,
                           const Theme& theme);

}  // namespace ui
