#pragma once

#include <QFont>
#include <QRgb>

#include "ui/style/theme.h"

namespace ui {

/// How a scene is drawn, apart from what is in it.
struct SceneLook {
  Theme theme;
  QFont font;               ///< its size in pixels
  double headerHeight = 0;  ///< kept free above everything, for a title [px]
  bool trails = true;
};

/// `font` with its size in pixels, at least 16 of them: 12 pt at the usual 96 dpi.
QFont readableFont(const QFont& font);

/// Height of a line of words [px].
double lineHeight(const QFont& font);

/// Width of these words [px].
double widthOf(const QString& words, const QFont& font);

/// The color with this opacity, 0 to 1.
QRgb withOpacity(const QColor& color, double opacity);

/// The color where it stands out from the room, else a mix with the outline's that does.
QRgb visibleInRoom(QRgb color, const Theme& theme);

/// Between the two: `share` 0 is the first, 1 the second. Opaque.
QRgb mixed(QRgb first, QRgb second, double share);

}  // namespace ui
