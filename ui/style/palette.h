#pragma once

#include <QPalette>

namespace ui {

struct Theme;

/// The palette of all widgets, in colors that go with the theme's drawings.
QPalette paletteOf(const Theme& theme);

}  // namespace ui
