#include "ui/style/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace ui {
namespace {

// What the icon files are drawn in.
const QByteArray kDrawnColor = "#000000";

void drawSvg(QPainter& painter, const QByteArray& svg, const QRectF& place, const QColor& color) {
  QSvgRenderer renderer(QByteArray(svg).replace(kDrawnColor, color.name().toLatin1()));
  renderer.render(&painter, place);
}

QByteArray svgOf(const QString& name) {
  QFile file(":/icons/" + name + ".svg");
  const bool opened = file.open(QIODevice::ReadOnly);
  Q_ASSERT_X(opened, "icon", qPrintable(name));
  return opened ? file.readAll() : QByteArray();
}

QColor colorFor(QIcon::Mode mode) {
  const QPalette palette = QApplication::palette();
  if (mode == QIcon::Disabled) return palette.color(QPalette::Disabled, QPalette::ButtonText);
  if (mode == QIcon::Selected) return palette.color(QPalette::HighlightedText);
  return palette.color(QPalette::ButtonText);
}

/// Draws an SVG of one color in the color the palette asks for at that moment.
class TintedIcon : public QIconEngine {
 public:
  explicit TintedIcon(QByteArray svg) : m_svg(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    drawSvg(*painter, m_svg, rect, colorFor(mode));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }

  QIconEngine* clone() const override { return new TintedIcon(m_svg); }

 private:
  QByteArray m_svg;
};

}  // namespace

QIcon icon(const QString& name) {
  const QByteArray svg = svgOf(name);
  return svg.isEmpty() ? QIcon() : QIcon(new TintedIcon(svg));
}

void drawIcon(QPainter& painter, const QString& name, const QRectF& place, const QColor& color) {
  drawSvg(painter, svgOf(name), place, color);
}

}  // namespace ui
