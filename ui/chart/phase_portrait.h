#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// Phase portrait: angular velocity against angle, while a weight swings on its taut rope.
ChartContent phasePortrait(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
