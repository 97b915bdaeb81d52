#pragma once

#include "ui/chart/chart_content.h"

namespace ui {

/// Paths of the weights' centers, y against x.
ChartContent paths(const ChartSubject& subject, const Theme& theme);

}  // namespace ui
