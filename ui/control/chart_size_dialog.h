#pragma once

#include <optional>

#include <QSizeF>

class QWidget;

namespace ui {

/// Whether a chart can be exported in this size [mm]: 40 to 1000 each way.
bool isChartSize(QSizeF size);

/// Asks how large an exported chart shall be.
///
/// @param suggested  offered first [mm]
/// @return           in mm on paper; nothing if the user thought better of it
std::optional<QSizeF> askChartSize(QWidget* window, QSizeF suggested);

}  // namespace ui
