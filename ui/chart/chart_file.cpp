#include "ui/chart/chart_file.h"

#include <cmath>

#include <QBuffer>
#include <QChart>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QXYSeries>

#include "ui/chart/chart_look.h"
#include "ui/files/output_file.h"

namespace ui {

namespace {

constexpr double kMillimetersPerInch = 25.4;
constexpr int kPngDotsPerInch = 2 * kPaperDotsPerInch;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartFile)
};

/// Of the chart in its scene [px].
QSizeF paperSize(QSizeF millimeters) {
  return millimeters * kPaperDotsPerInch / kMillimetersPerInch;
}

/// Qt paints solid curves piece by piece, which shows at bends under a magnifying glass and
/// makes vector files many times larger; curves of dashes it paints whole. So: one dash.
void paintCurvesWhole(QChart& chart) {
  constexpr double kLongerThanAnyCurve = 1e5;
  for (QAbstractSeries* series : chart.series()) {
    auto* curve = qobject_cast<QXYSeries*>(series);
    if (curve == nullptr || curve->pen().style() != Qt::SolidLine) continue;
    QPen pen = curve->pen();
    pen.setDashPattern({kLongerThanAnyCurve, 1});
    pen.setJoinStyle(Qt::RoundJoin);
    curve->setPen(pen);
  }
}

void paint(QChart& chart, QPaintDevice& device, const QRectF& target) {
  QPainter painter(&device);
  painter.setRenderHint(QPainter::Antialiasing);
  chart.scene()->render(&painter, target, chart.sceneBoundingRect());
}

QImage pixels(QChart& chart, QSizeF size) {
  const QSizeF count = size * kPngDotsPerInch / kMillimetersPerInch;
  QImage image(count.toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  paint(chart, image, image.rect());
  // Only now: with it the painter would enlarge type that the scene enlarges already.
  image.setDotsPerMeterX(qRound(1000 * kPngDotsPerInch / kMillimetersPerInch));
  image.setDotsPerMeterY(image.dotsPerMeterX());
  return image;
}

QByteArray png(QChart& chart, const QString&, QSizeF size) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  pixels(chart, size).save(&buffer, "PNG");
  return bytes;
}

QByteArray svg(QChart& chart, const QString& title, QSizeF size) {
  const QRectF area(QPointF(0, 0), paperSize(size));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(kPaperDotsPerInch);
  generator.setSize(area.size().toSize());
  generator.setViewBox(area);
  generator.setTitle(title);
  paint(chart, generator, area);
  return bytes;
}

QByteArray pdf(QChart& chart, const QString& title, QSizeF size) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(size, QPageSize::Millimeter));
  writer.setPageMargins(QMarginsF());
  writer.setCreator(QCoreApplication::applicationName());
  writer.setTitle(title);
  paint(chart, writer, QRectF(0, 0, writer.width(), writer.height()));
  return bytes;
}

void layOut(QChart& chart, QSizeF size) {
  chart.resize(paperSize(size));
  chart.layout()->activate();
  paintCurvesWhole(chart);
}

}  // namespace

QString writeChart(QChart& chart, const QString& file, const QString& title, QSizeF size) {
  const QString ending = QFileInfo(file).suffix().toLower();
  const auto encoded = ending == "png"   ? png
                       : ending == "svg" ? svg
                       : ending == "pdf" ? pdf
                                         : nullptr;
  if (encoded == nullptr) return Words::tr("a chart's file ends in .png, .svg or .pdf");
  layOut(chart, size);
  return writeWhole(file, encoded(chart, title, size));
}

QImage chartImage(QChart& chart, QSizeF size) {
  layOut(chart, size);
  return pixels(chart, size);
}

}  // namespace ui
