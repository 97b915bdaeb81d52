#include "ui/view/protractor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <QLocale>

#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kWidth = 3;       // [px]
constexpr double kArcRadius = 56;  // at most [px]
constexpr double kArcShare = 0.7;  // of the shorter arm at most
constexpr double kDistance = 10;   // from the arc to the words [px]

double directionOf(const Eigen::Vector2d& way) {
  return std::atan2(way.y(), way.x());
}

double arcRadius(const Protractor& protractor, const Camera& camera) {
  const double shorter = std::min((protractor.first - protractor.vertex).norm(),
                                  (protractor.second - protractor.vertex).norm());
  return std::min(kArcRadius / camera.scale(), kArcShare * shorter);
}

/// From the first arm, the short way to the second.
double turn(const Protractor& protractor) {
  return std::remainder(directionOf(protractor.second - protractor.vertex) -
                            directionOf(protractor.first - protractor.vertex),
                        2 * std::numbers::pi);
}

Eigen::Vector2d onArc(const Protractor& protractor, double share, double radius) {
  const double direction =
      directionOf(protractor.first - protractor.vertex) + share * turn(protractor);
  return protractor.vertex + radius * Eigen::Vector2d(std::cos(direction), std::sin(direction));
}

void addArc(const Protractor& protractor, double radius, QRgb color, Layer& layer) {
  constexpr int kPieces = 48;
  std::vector<Eigen::Vector2d> arc;
  for (int i = 0; i <= kPieces; ++i)
    arc.push_back(onArc(protractor, static_cast<double>(i) / kPieces, radius));
  layer.polylines.push_back({std::move(arc), kWidth - 1, color, /*fading=*/false});
}

}  // namespace

double Protractor::angle() const {
  return std::abs(turn(*this));
}

void drawProtractor(const Protractor& protractor, const Camera& camera, const SceneLook& look,
                    Drawing& drawing) {
  const QRgb color = look.theme.lostToImpacts.rgb();
  Layer& layer = drawing.layers[kToolLayer];
  for (const Eigen::Vector2d& end : {protractor.first, protractor.second})
    layer.lines.push_back({protractor.vertex, end, kWidth, color});
  const double radius = arcRadius(protractor, camera);
  addArc(protractor, radius, color, layer);

  QFont large = look.font;
  large.setPixelSize(look.font.pixelSize() * 5 / 4);
  large.setBold(true);
  const double degrees = protractor.angle() * 180 / std::numbers::pi;
  const QString words = QLocale().toString(degrees, 'f', 1) + QChar(0x00b0);
  const QSizeF box(widthOf(words, large), lineHeight(large));
  const QPointF vertex = camera.toPixels(protractor.vertex);
  // Beyond the arc, along the middle between the arms.
  QPointF along = camera.toPixels(onArc(protractor, 0.5, 1)) - vertex;
  along /= std::hypot(along.x(), along.y());
  const double reach = radius * camera.scale() + kDistance + std::abs(along.x()) * box.width() / 2 +
                       std::abs(along.y()) * box.height() / 2;
  const QPointF corner = vertex + along * reach - QPointF(box.width() / 2, box.height() / 2);
  drawing.texts.push_back({camera.toMetres(corner), QPointF(0, 0), words, large,
                           look.theme.text.rgb(), withOpacity(look.theme.room, 0.85)});
}

}  // namespace ui
