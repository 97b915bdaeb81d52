#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// Speed of the weights over time.
ChartContent speedOverTime(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
