#include "ui/view/scene_look.h"

#include <algorithm>
#include <cmath>

#include <QFontInfo>
#include <QFontMetricsF>

namespace ui {

namespace {

constexpr int kLeastTextPixels = 16;

/// Relative luminance as WCAG 2.1 defines it, 0 to 1.
double luminance(QRgb color) {
  const auto linear = [](int channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(color)) + 0.7152 * linear(qGreen(color)) +
         0.0722 * linear(qBlue(color));
}

double contrast(QRgb a, QRgb b) {
  const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
  return (lighter + 0.05) / (darker + 0.05);
}

}  // namespace

QFont readableFont(const QFont& font) {
  QFont readable = font;
  readable.setPixelSize(std::max(QFontInfo(font).pixelSize(), kLeastTextPixels));
  return readable;
}

double lineHeight(const QFont& font) {
  return QFontMetricsF(font).height();
}

double widthOf(const QString& words, const QFont& font) {
  return QFontMetricsF(font).horizontalAdvance(words);
}

QRgb withOpacity(const QColor& color, double opacity) {
  return qRgba(color.red(), color.green(), color.blue(),
               static_cast<int>(std::lround(255 * opacity)));
}

QRgb mixed(QRgb first, QRgb second, double share) {
  const auto channel = [share](int a, int b) {
    return static_cast<int>(std::lround(a + share * (b - a)));
  };
  return qRgb(channel(qRed(first), qRed(second)), channel(qGreen(first), qGreen(second)),
              channel(qBlue(first), qBlue(second)));
}

QRgb visibleInRoom(QRgb color, const Theme& theme) {
  constexpr double kLeastContrast = 2.5;
  const QRgb outline = theme.outline.rgb();
  QRgb visible = color;
  for (double share = 0.1; share < 1; share += 0.1) {
    if (contrast(visible, theme.room.rgb()) >= kLeastContrast) break;
    visible = mixed(color, outline, share);
  }
  return visible;
}

}  // namespace ui
