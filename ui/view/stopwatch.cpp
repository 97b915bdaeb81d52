#include "ui/view/stopwatch.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QLocale>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kEdge = 10;    // between the face and the picture's [px]
constexpr double kPadding = 8;  // inside the face [px]
constexpr double kFrame = 2;    // [px]

QFont digitsFont(const SceneLook& look) {
  QFont font = look.font;
  font.setPixelSize(look.font.pixelSize() * 9 / 4);
  font.setBold(true);
  return font;
}

QString digits(double seconds) {
  // Adding zero turns −0 into 0.
  return QCoreApplication::translate("ui::SceneView", "%1 s")
      .arg(QLocale().toString(seconds + 0.0, 'f', 3));
}

QSizeF faceSize(const SceneLook& look) {
  return {widthOf(digits(-88.888), digitsFont(look)) + 2 * kPadding,
          lineHeight(digitsFont(look)) + lineHeight(look.font) + 1.5 * kPadding};
}

/// Where the face's upper left corner may lie [px].
QRectF freedom(double top, const Camera& camera, const SceneLook& look) {
  const QSizeF size = camera.viewport() - faceSize(look) - QSizeF(2 * kEdge, top + 2 * kEdge);
  return {QPointF(kEdge, top + kEdge), size.expandedTo(QSizeF(0, 0))};
}

double share(double value, double from, double length) {
  return length > 0 ? std::clamp((value - from) / length, 0.0, 1.0) : 0;
}

}  // namespace

void Stopwatch::startOrStop(double time) {
  counted = reading(time);
  since = isRunning() ? std::nullopt : std::optional(time);
}

void Stopwatch::setToZero(double time) {
  counted = 0;
  if (since) since = time;
}

QRectF stopwatchFace(const Stopwatch& stopwatch, double top, const Camera& camera,
                     const SceneLook& look) {
  const QRectF free = freedom(top, camera, look);
  return {free.topLeft() +
              QPointF(stopwatch.place.x() * free.width(), stopwatch.place.y() * free.height()),
          faceSize(look)};
}

void placeStopwatch(Stopwatch& stopwatch, QPointF corner, double top, const Camera& camera,
                    const SceneLook& look) {
  const QRectF free = freedom(top, camera, look);
  stopwatch.place = QPointF(share(corner.x(), free.left(), free.width()),
                            share(corner.y(), free.top(), free.height()));
}

void drawStopwatch(const Stopwatch& stopwatch, double time, bool isChosen, double top,
                   const Camera& camera, const SceneLook& look, Drawing& drawing) {
  const QRectF face = stopwatchFace(stopwatch, top, camera, look);
  const QColor& frame = isChosen ? look.theme.text : look.theme.lostToImpacts;
  const double width = isChosen ? 2 * kFrame : kFrame;
  Layer& layer = drawing.layers[kToolLayer];
  layer.rectangles.push_back(rectangleAt(face, camera, frame.rgb()));
  layer.rectangles.push_back(rectangleAt(face.adjusted(width, width, -width, -width), camera,
                                         withOpacity(look.theme.background, 1)));
  const auto add = [&](const QString& words, const QFont& font, QPointF corner) {
    drawing.texts.push_back(
        {camera.toMetres(corner), QPointF(0, 0), words, font, look.theme.text.rgb()});
  };
  const QString name = stopwatch.isRunning()
                           ? QCoreApplication::translate("ui::SceneView", "stopwatch runs")
                           : QCoreApplication::translate("ui::SceneView", "stopwatch stands");
  const QString number = digits(stopwatch.reading(time));
  const QFont large = digitsFont(look);
  add(name, look.font, face.topLeft() + QPointF(kPadding, kPadding / 2));
  // At the right, so that no digit moves when the number gets longer.
  add(number, large,
      QPointF(face.right() - kPadding - widthOf(number, large),
              face.top() + kPadding / 2 + lineHeight(look.font)));
}

}  // namespace ui
