#pragma once

#include <QString>

namespace ui {

class ChartPlot;

/// The points of all curves that are shown, from the first moment the chart shows to the last,
/// as a table for spreadsheets: a heading, then one row a sample; for each run a column of
/// times and one or two for each curve. Numbers read back exactly.
///
/// @param separator     between columns
/// @param decimalPoint  as the reader's spreadsheet expects it
QString chartTable(const ChartPlot& plot, QChar separator, const QString& decimalPoint);

}  // namespace ui
