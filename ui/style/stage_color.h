#pragma once

#include <cstddef>

#include <QColor>

namespace ui {

struct Theme;

/// The color of a method's first, second, … slope, the same in plot and scene.
QColor stageColor(std::size_t index, const Theme& theme);

}  // namespace ui
