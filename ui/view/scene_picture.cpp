#include "ui/view/scene_picture.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "ui/files/lessons.h"
#include "ui/files/output_file.h"
#include "ui/view/camera.h"
#include "ui/view/qpainter_renderer.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

namespace ui {

namespace {

constexpr double kPixelsPerInch = 96;
constexpr double kPngScale = 2;
constexpr double kEdge = 10;  // [px]

struct ScenePicture {
  Q_DECLARE_TR_FUNCTIONS(ui::ScenePicture)
};

struct Picture {
  QString title;
  QSize size;  // [px]
  Camera camera;
  Drawing drawing;
};

void addTitle(const ShownScene& shown, const QFont& font, const SceneLook& look, Picture& picture) {
  const QString time = ScenePicture::tr("t = %1 s").arg(QLocale().toString(shown.time, 'f', 3));
  const double right = picture.size.width() - kEdge - widthOf(time, font);
  const auto add = [&](double left, const QString& words) {
    picture.drawing.texts.push_back({picture.camera.toMetres({left, kEdge}), QPointF(0, 0), words,
                                     font, look.theme.text.rgb()});
  };
  add(kEdge, picture.title);
  add(right, time);
}

Picture pictureOf(const ShownScene& shown, const Trails& trails, QSize size,
                  double devicePixelRatio) {
  SceneLook look{Theme::light(), readableFont(QGuiApplication::font())};
  look.theme.background = Qt::white;
  QFont titleFont = look.font;
  titleFont.setPixelSize(look.font.pixelSize() * 3 / 2);
  titleFont.setBold(true);
  look.headerHeight = lineHeight(titleFont) + kEdge;

  Picture picture;
  picture.title = shown.scene.name.empty() ? ScenePicture::tr("Scene") : titleOf(shown.scene);
  picture.size = size;
  picture.camera.setViewport(size, devicePixelRatio);
  picture.camera.fit(QSizeF(shown.scene.room.width, shown.scene.room.height),
                     sceneMargins(shown, look, size.width()));
  picture.drawing = sceneDrawing(shown, trails, picture.camera, look);
  addTitle(shown, titleFont, look, picture);
  return picture;
}

QByteArray pngOf(const Picture& picture) {
  QImage image(picture.size * kPngScale, QImage::Format_RGB32);
  paintDrawing(picture.drawing, picture.camera, image);
  const int dotsPerMetre = qRound(kPngScale * kPixelsPerInch / 0.0254);
  image.setDotsPerMeterX(dotsPerMetre);
  image.setDotsPerMeterY(dotsPerMetre);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  image.save(&buffer, "PNG");
  return bytes;
}

QByteArray svgOf(const Picture& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(static_cast<int>(kPixelsPerInch));
  generator.setSize(picture.size);
  generator.setViewBox(QRect(QPoint(0, 0), picture.size));
  generator.setTitle(picture.title);
  QPainter painter(&generator);
  paintDrawing(picture.drawing, picture.camera, painter);
  painter.end();
  return bytes;
}

QByteArray pdfOf(const Picture& picture) {
  constexpr int kUnitsPerInch = 1200;
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(picture.title);
  writer.setResolution(kUnitsPerInch);
  writer.setPageSize(QPageSize(QSizeF(picture.size) / kPixelsPerInch, QPageSize::Inch, QString(),
                               QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF(0, 0, 0, 0));
  QPainter painter(&writer);
  painter.scale(kUnitsPerInch / kPixelsPerInch, kUnitsPerInch / kPixelsPerInch);
  paintDrawing(picture.drawing, picture.camera, painter);
  painter.end();
  return bytes;
}

}  // namespace

QString writeScenePicture(const QString& file, const std::vector<const core::Run*>& runs,
                          double time, QSize size, const PicturedMarks& pictured) {
  ShownScene shown = shownScene(runs);
  readWeights(runs, time, shown);
  shown.marks = pictured.marks;
  shown.marks.selection.reset();
  shown.marks.tools.chosen.reset();
  if (pictured.target) shown.target = *pictured.target;
  const auto picture = [&](double devicePixelRatio) {
    return pictureOf(shown, pictured.trails ? *pictured.trails : Trails(), size, devicePixelRatio);
  };
  const QString ending = QFileInfo(file).suffix().toLower();
  if (ending == QLatin1String("png")) return writeWhole(file, pngOf(picture(kPngScale)));
  if (ending == QLatin1String("svg")) return writeWhole(file, svgOf(picture(1)));
  if (ending == QLatin1String("pdf")) return writeWhole(file, pdfOf(picture(1)));
  return ScenePicture::tr("a picture's name must end in .png, .svg or .pdf");
}

}  // namespace ui
