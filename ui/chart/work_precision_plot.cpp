#include "ui/chart/work_precision_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <QChart>
#include <QLineSeries>
#include <QScatterSeries>

#include "core/trade/work_precision.h"
#include "ui/control/run_words.h"
#include "ui/control/trade_words.h"

namespace ui {
namespace {

constexpr double kLineWidth = 2.5;
constexpr double kMarkSize = 0.75;  // of the font's size
constexpr double kLabelGap = 0.6;
constexpr std::array kGuideSlopes{1, 4};
constexpr double kNanoseconds = 1e-9;  // [s]

// With the color a second way to tell methods apart.
constexpr std::array kMarks{QScatterSeries::MarkerShapeCircle, QScatterSeries::MarkerShapeRectangle,
                            QScatterSeries::MarkerShapeTriangle,
                            QScatterSeries::MarkerShapeRotatedRectangle};

/// The method's place in the table decides its color and mark.
std::size_t placeInTable(const core::Method* method) {
  return static_cast<std::size_t>(method - core::methods().data());
}

}  // namespace

WorkPrecisionPlot::WorkPrecisionPlot(QChart* chart)
    : QObject(chart), m_chart(chart), m_frame(new LogFrame(chart)) {
  connect(m_frame, &LogFrame::resized, this, &WorkPrecisionPlot::showScales);
  connect(chart, &QChart::plotAreaChanged, this, &WorkPrecisionPlot::placeLabels);
}

void WorkPrecisionPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  update();
}

void WorkPrecisionPlot::setTitle(const QString& title) {
  m_title = title;
  update();
}

void WorkPrecisionPlot::setAgainst(ErrorAgainst against) {
  m_against = against;
  update();
}

void WorkPrecisionPlot::setMeasurement(std::shared_ptr<const core::Measurement> measurement) {
  m_measurement = std::move(measurement);
  update();
}

QPointF WorkPrecisionPlot::placeOf(const core::MeasuredPoint& point) const {
  const double x = m_against == ErrorAgainst::kCost
                       ? kNanoseconds * point.nanosecondsPerSimulatedSecond
                       : core::effectiveStep(*m_measurement, point);
  return {std::log10(x), std::log10(point.maxPositionError)};
}

void WorkPrecisionPlot::update() {
  m_frame->removeCurves();
  for (const Label& label : m_labels) delete label.text;
  m_labels.clear();
  m_extent = QRectF();
  HeadingContent heading;
  heading.title = m_title;
  if (m_measurement) heading.note = measuredTimeWords(*m_measurement);
  m_frame->setHeading(std::move(heading));
  if (!m_measurement) return;

  for (const core::MethodCurve& curve : m_measurement->curves) {
    const auto& colors = m_frame->look().theme.runs;
    showCurve(curve, colors[placeInTable(curve.method) % colors.size()]);
  }
  showScales();
  if (m_against == ErrorAgainst::kStep && !m_extent.isNull()) {
    for (const int slope : kGuideSlopes) showGuide(slope);
  }
  placeLabels();
}

void WorkPrecisionPlot::showCurve(const core::MethodCurve& curve, const QColor& color) {
  const std::vector<core::MeasuredPoint> points = core::chartedPoints(curve);
  if (points.empty()) return;
  auto* line = new QLineSeries;
  auto* marks = new QScatterSeries;
  line->setName(methodWords(*curve.method));
  std::vector<QPointF> places;
  for (const core::MeasuredPoint& point : points) {
    places.push_back(placeOf(point));
    *line << places.back();
    *marks << places.back();
    const QRectF spot(places.back(), QSizeF(1e-9, 1e-9));
    m_extent = m_extent.isNull() ? spot : m_extent.united(spot);
  }
  line->setPen(QPen(color, kLineWidth));
  m_frame->add(line);
  marks->setMarkerShape(kMarks[placeInTable(curve.method) % kMarks.size()]);
  marks->setMarkerSize(kMarkSize * m_frame->look().font.pixelSize());
  m_frame->add(marks);
  marks->setColor(color);
  marks->setBorderColor(m_frame->look().theme.room);
  connect(marks, &QScatterSeries::clicked, this, [this, points](const QPointF& place) {
    const auto nearest = std::ranges::min_element(
        points, {}, [&](const auto& point) { return (placeOf(point) - place).manhattanLength(); });
    emit pointPicked(nearest->solver);
  });
  addLabel(orderWords(*m_measurement, curve), color, std::move(places));
}

/// A straight line through the middle of the chart, for the eye to compare slopes with.
void WorkPrecisionPlot::showGuide(int slope) {
  const QPointF middle = m_extent.center();
  const double half = std::min(m_extent.width(), m_extent.height() / slope) / 2;
  auto* guide = new QLineSeries;
  std::vector<QPointF> places;
  for (const double share : {1.0, 0.75, 0.5, -0.25, -0.5, -0.75, -1.0}) {
    places.push_back(middle + share * QPointF(half, half * slope));
  }
  *guide << places.front() << places.back();
  m_frame->add(guide);
  const QColor color = m_frame->look().theme.faintText;
  guide->setPen(QPen(color, 1.5, Qt::DashLine));
  addLabel(tr("slope %1").arg(slope), color, std::move(places));
}

void WorkPrecisionPlot::addLabel(const QString& words, const QColor& color,
                                 std::vector<QPointF> curve) {
  auto* text = new QGraphicsSimpleTextItem(words, m_chart);
  QFont font = m_frame->look().font;
  font.setBold(true);
  text->setFont(font);
  text->setBrush(color);
  text->setZValue(m_chart->zValue() + 20);  // above curves
  m_labels.push_back({text, std::move(curve)});
}

void WorkPrecisionPlot::showScales() {
  if (!m_measurement || m_extent.isNull()) return;
  const auto value = [](double logarithm) { return std::pow(10, logarithm); };
  const int across = m_frame->horizontalLabels();
  const double left = value(m_extent.left()), right = value(m_extent.right());
  if (m_against == ErrorAgainst::kCost) {
    m_frame->setHorizontal(decadeScale(left, right, QStringLiteral("s"), across),
                           tr("Computing time per simulated second"));
  } else {
    m_frame->setHorizontal(stepScale(left, right, across), tr("Step"));
  }
  m_frame->setVertical(decadeScale(value(m_extent.top()), value(m_extent.bottom()),
                                   QStringLiteral("m"), m_frame->verticalLabels()),
                       tr("Largest position error"));
}

void WorkPrecisionPlot::placeLabels() {
  if (m_labels.empty()) return;
  QAbstractSeries* any = m_chart->series().constFirst();
  std::vector<LabelledCurve> curves;
  for (const Label& label : m_labels) {
    LabelledCurve curve{{}, label.text->boundingRect().size()};
    for (const QPointF& point : label.curve) {
      curve.points.push_back(m_chart->mapToPosition(point, any));
    }
    curves.push_back(std::move(curve));
  }
  const double gap = kLabelGap * m_frame->look().font.pixelSize();
  const std::vector<QRectF> places = labelPlaces(curves, m_chart->plotArea(), gap);
  for (std::size_t i = 0; i < m_labels.size(); ++i) m_labels[i].text->setPos(places[i].topLeft());
}

}  // namespace ui
