#include "ui/chart/cut_sweep_plot.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <QChart>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGraphicsScene>
#include <QPainter>

#include "ui/chart/chart_content.h"
#include "ui/chart/chart_file.h"
#include "ui/chart/curves_item.h"
#include "ui/chart/line_series.h"

namespace ui {
namespace {

using core::FirstHit;

constexpr QSizeF kPaperSize(200, 125);  // [mm]
constexpr double kLineWidth = 3;        // [px]
constexpr double kThinWidth = 1.5;      // [px]
constexpr double kHitWidth = 6;         // [px]
constexpr double kDotRadius = 5;        // [px]
constexpr int kBandAlpha = 56;
constexpr int kPlateAlpha = 217;
constexpr std::array kFirstHits{FirstHit::kNothing, FirstHit::kWall, FirstHit::kWeight};

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::CutSweep)
};

QString legendWords(FirstHit hit) {
  return hit == FirstHit::kNothing ? Words::tr("straight to the floor") : firstHitWords(hit);
}

/// What happens on the way makes places change too fast for broad lines or dashes.
QPen penOf(FirstHit hit, const Theme& theme) {
  switch (hit) {
    case FirstHit::kNothing:
      break;
    case FirstHit::kWall:
      return {theme.potential, kThinWidth};
    case FirstHit::kWeight:
      return {theme.kinetic, kThinWidth};
  }
  return {theme.text, kLineWidth};
}

QColor bandColor(const Theme& theme) {
  QColor color = theme.drift;
  color.setAlpha(kBandAlpha);
  return color;
}

/// The lines of all pieces in which that was hit first. A landing unlike both its neighbours is
/// too short a piece for a line.
std::vector<QPolygonF> piecesOf(const CutSweepResult& result, FirstHit hit) {
  std::vector<QPolygonF> pieces;
  const core::Landing* before = nullptr;
  for (const core::Landing& landing : result.landings) {
    const bool isShown =
        landing.outcome == core::LandingOutcome::kLanded && landing.firstHit == hit;
    if (isShown && (!before || !areAlike(*before, landing))) pieces.emplace_back();
    if (isShown) pieces.back().append({landing.cutTime, landing.place});
    before = isShown ? &landing : nullptr;
  }
  return pieces;
}

DrawnCurve bandOf(const CutSweepResult& result, const Theme& theme) {
  DrawnCurve band;
  band.pen = Qt::NoPen;
  band.fill = bandColor(theme);
  band.areas = {QPolygonF(QRectF(QPointF(result.question.from, result.target.west()),
                                 QPointF(result.question.until, result.target.east())))};
  return band;
}

HeadingEntry entryOf(const QPen& line, const QString& text) {
  HeadingEntry entry;
  entry.line = line;
  entry.text = text;
  return entry;
}

}  // namespace

/// The stretches that hit, over the curves, with the times to cut at.
class CutSweepPlot::Hits : public QGraphicsItem {
 public:
  Hits(QChart* chart, const CutSweepPlot* plot) : QGraphicsItem(chart), m_plot(plot) {
    constexpr double kAboveCurves = 11;
    setZValue(kAboveCurves);
  }

  void refresh() {
    prepareGeometryChange();
    update();
  }

  QRectF boundingRect() const override { return {QPointF(0, 0), m_plot->m_chart->size()}; }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const CutSweepResult* result = m_plot->result();
    if (!result) return;
    const QTransform toChart = m_plot->toChart();
    const Theme& theme = m_plot->look().theme;
    // The easiest lie on top.
    const std::vector<core::Hit> hits(result->hits.rbegin(), result->hits.rend());
    for (const core::Hit& hit : hits) {
      painter->setPen(QPen(theme.drift, kHitWidth, Qt::SolidLine, Qt::FlatCap));
      painter->setBrush(Qt::NoBrush);
      painter->drawPolyline(simplified(toChart.map(stretch(*result, hit)), 0.2));
    }
    for (const core::Hit& hit : hits) paintDot(*painter, placeOf(*result, hit), theme);
    paintTimes(*painter, *result, toChart, theme);
  }

 private:
  static QPolygonF stretch(const CutSweepResult& result, const core::Hit& hit) {
    QPolygonF line;
    const auto from =
        std::ranges::lower_bound(result.landings, hit.from, {}, &core::Landing::cutTime);
    for (auto landing = from; landing != result.landings.end(); ++landing) {
      if (landing->cutTime > hit.until) break;
      line.append({landing->cutTime, landing->place});
    }
    return line;
  }

  /// Its best moment is sampled, or lies on the center line.
  QPointF placeOf(const CutSweepResult& result, const core::Hit& hit) const {
    if (!hit.centers.empty()) return m_plot->toChart().map(QPointF(hit.best, result.target.center));
    const auto landing =
        std::ranges::lower_bound(result.landings, hit.best, {}, &core::Landing::cutTime);
    const double place = landing == result.landings.end() ? result.target.center : landing->place;
    return m_plot->toChart().map(QPointF(hit.best, place));
  }

  static void paintDot(QPainter& painter, QPointF place, const Theme& theme) {
    painter.setPen(QPen(theme.room, 2));
    painter.setBrush(theme.drift);
    painter.drawEllipse(place, kDotRadius + 1, kDotRadius + 1);
  }

  /// Above the band, or below it where there is no room above; of as many as have room, those
  /// that are easiest to hit.
  void paintTimes(QPainter& painter, const CutSweepResult& result, const QTransform& toChart,
                  const Theme& theme) const {
    QFont font = m_plot->look().font;
    font.setBold(true);
    const QFontMetricsF metrics(font);
    const QRectF plot = m_plot->m_chart->plotArea();
    const double gap = 0.4 * metrics.height();
    const double above = toChart.map(QPointF(0, result.target.east())).y() - gap - metrics.height();
    const double below = toChart.map(QPointF(0, result.target.west())).y() + gap;
    const double top = above >= plot.top() ? above : below;
    std::vector<QRectF> taken;
    painter.setFont(font);
    for (const core::Hit& hit : result.hits) {
      const QString words = Words::tr("%1 s").arg(cutTimeText(hit.best));
      const double width = metrics.horizontalAdvance(words) + gap;
      const double x = toChart.map(QPointF(hit.best, 0)).x() - width / 2;
      const QRectF box(std::clamp(x, plot.left(), plot.right() - width), top, width,
                       metrics.height());
      const auto overlaps = [&](const QRectF& other) {
        return other.adjusted(-gap, 0, gap, 0).intersects(box);
      };
      if (std::ranges::any_of(taken, overlaps)) continue;
      taken.push_back(box);
      QColor plate = theme.room;
      plate.setAlpha(kPlateAlpha);
      painter.fillRect(box, plate);
      painter.setPen(theme.text);
      painter.drawText(box, Qt::AlignCenter, words);
    }
  }

  const CutSweepPlot* m_plot;
};

CutSweepPlot::CutSweepPlot(QChart* chart)
    : QObject(chart),
      m_chart(chart),
      m_frame(new ChartFrame(chart)),
      m_curves(new CurvesItem(chart)),
      m_hits(new Hits(chart, this)) {
  addLineSeries(chart);  // without a curve of its own Qt shows no axes
  connect(m_frame, &ChartFrame::resized, this, &CutSweepPlot::showScales);
}

CutSweepPlot::~CutSweepPlot() = default;

void CutSweepPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  update();
}

void CutSweepPlot::setResult(std::shared_ptr<const CutSweepResult> result) {
  m_result = std::move(result);
  update();
}

QTransform CutSweepPlot::toChart() const {
  return plotTransform(m_range, m_chart->plotArea());
}

void CutSweepPlot::update() {
  const Theme& theme = m_frame->look().theme;
  HeadingContent heading;
  std::vector<DrawnCurve> curves;
  if (m_result) {
    heading.title = m_result->sceneName;
    heading.note = sweepNote(*m_result);
    for (const FirstHit hit : kFirstHits) {
      DrawnCurve curve;
      curve.pen = penOf(hit, theme);
      curve.lines = piecesOf(*m_result, hit);
      if (curve.lines.empty()) continue;
      heading.legend.push_back(entryOf(curve.pen, legendWords(hit)));
      curves.push_back(std::move(curve));
    }
    curves.push_back(bandOf(*m_result, theme));
    heading.legend.push_back(
        entryOf(QPen(bandColor(theme), 2 * kHitWidth, Qt::SolidLine, Qt::FlatCap), tr("target")));
    if (!m_result->hits.empty())
      heading.legend.push_back(entryOf(QPen(theme.drift, kHitWidth), tr("hits it")));
  }
  m_frame->setHeading(std::move(heading));
  showScales();
  m_curves->setCurves(std::move(curves), m_range);
}

/// Of the curve and the target, within the room.
QRectF CutSweepPlot::extent() const {
  double lowest = m_result->target.west(), highest = m_result->target.east();
  for (const core::Landing& landing : m_result->landings) {
    if (landing.outcome != core::LandingOutcome::kLanded) continue;
    lowest = std::min(lowest, landing.place);
    highest = std::max(highest, landing.place);
  }
  lowest = std::max(0.0, lowest);
  highest = std::min(m_result->room.width, highest);
  return {QPointF(m_result->question.from, lowest), QPointF(m_result->question.until, highest)};
}

void CutSweepPlot::showScales() {
  if (!m_result) return;
  const ChartAxis time{.quantity = tr("Cut at"), .unit = tr("s"), .prefixed = false};
  const ChartAxis place{.quantity = tr("Lands at"), .unit = tr("m")};
  const QRectF shown = extent();
  const AxisScale across = axisScale(time, shown.left(), shown.right(),
                                     m_frame->horizontalIntervals(), AxisEnds::kExact);
  const AxisScale up = axisScale(place, shown.top(), shown.bottom(), m_frame->verticalIntervals(),
                                 AxisEnds::kOnTicks);
  m_frame->setHorizontal(across, time.quantity);
  m_frame->setVertical(up, place.quantity);
  const QRectF range(QPointF(across.lowest, up.lowest * up.unit.size),
                     QPointF(across.highest, up.highest * up.unit.size));
  if (range != m_range) {
    m_range = range;
    m_curves->setCurves(m_curves->curves(), m_range);
  }
  m_hits->refresh();
}

namespace {

/// A chart for paper in a scene of its own.
struct PaperChart {
  explicit PaperChart(std::shared_ptr<const CutSweepResult> result) : chart(new QChart) {
    scene.addItem(chart);
    auto* plot = new CutSweepPlot(chart);
    plot->setLook(ChartLook::forPaper());
    plot->setResult(std::move(result));
  }

  QGraphicsScene scene;
  QChart* chart;  // owned by the scene
};

}  // namespace

QString writeCutSweepChart(const QString& file, std::shared_ptr<const CutSweepResult> result) {
  const QString title = result->sceneName;
  PaperChart paper(std::move(result));
  return writeChart(*paper.chart, file, title, kPaperSize);
}

QImage cutSweepImage(std::shared_ptr<const CutSweepResult> result) {
  PaperChart paper(std::move(result));
  return chartImage(*paper.chart, kPaperSize);
}

}  // namespace ui
