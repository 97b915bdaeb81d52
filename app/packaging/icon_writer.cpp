#include <cstdio>

#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

namespace {

/// Square, and transparent around what is drawn.
QImage pictureOf(QSvgRenderer& drawing, int size) {
  QImage picture(size, size, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  drawing.render(&painter);
  return picture;
}

}  // namespace

/// `icon_writer DRAWING.svg START SIZE...` writes START<SIZE>.png for each size [px].
int main(int argc, char** argv) {
  if (argc < 4) return 2;
  QSvgRenderer drawing(QString::fromLocal8Bit(argv[1]));
  if (!drawing.isValid()) {
    std::fprintf(stderr, "%s is no SVG drawing\n", argv[1]);
    return 1;
  }
  for (int i = 3; i < argc; ++i) {
    const QString size = QString::fromLocal8Bit(argv[i]);
    const QString file = QString::fromLocal8Bit(argv[2]) + size + QStringLiteral(".png");
    if (!pictureOf(drawing, size.toInt()).save(file)) {
      std::fprintf(stderr, "%s cannot be written\n", qPrintable(file));
      return 1;
    }
  }
  return 0;
}
