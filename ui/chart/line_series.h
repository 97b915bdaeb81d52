#pragma once

class QChart;
class QLineSeries;

namespace ui {

/// A new line along both axes of a chart that has them; belongs to the chart.
QLineSeries* addLineSeries(QChart* chart);

}  // namespace ui
