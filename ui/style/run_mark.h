#pragma once

#include <QPixmap>

namespace ui {

struct Theme;

/// How a run's weights look in the scene: a disc for the first run, a ring in its color for
/// each other one.
QPixmap runMark(int run, const Theme& theme, double devicePixelRatio);

}  // namespace ui
