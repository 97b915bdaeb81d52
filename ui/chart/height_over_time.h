#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// Height of the weights' centers above the floor over time.
ChartContent heightOverTime(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
