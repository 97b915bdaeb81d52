#include "ui/chart/chart_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QChart>

#include "ui/chart/curve_pieces.h"
#include "ui/chart/curves_item.h"
#include "ui/chart/plot_heading.h"
#include "ui/chart/run_pen.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Between the highest curve and the top of the plot.
constexpr double kHeadroom = 1.04;
// A unit may be so many times as wide as high before equal units are given up.
constexpr double kMostStretch = 6;
constexpr double kBandFaintness = 0.25;  // between the color and that of the plot

/// So that no curve runs along the edge.
void addMargins(CurveExtent& extent, bool fromZero) {
  constexpr double kMargin = 0.03;
  const double x = kMargin * (extent.highestX - extent.lowestX);
  const double y = kMargin * (extent.highestY - extent.lowestY);
  extent.lowestX -= x;
  extent.highestX += x;
  if (!fromZero) extent.lowestY -= y;
  extent.highestY += y;
}

/// At least some width, so that there is a scale for a single value.
void widen(double& lowest, double& highest) {
  if (lowest < highest) return;
  const double half = std::max(std::abs(lowest) / 10, 0.5);
  lowest -= half;
  highest += half;
}

}  // namespace

ChartPlot::ChartPlot(QChart* chart)
    : QObject(chart),
      m_frame(new ChartFrame(chart)),
      m_curves(new CurvesItem(chart)),
      m_chart(chart),
      m_kind(&energyChartKind()) {
  connect(m_frame, &ChartFrame::resized, this, &ChartPlot::update);
}

void ChartPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  rebuild();
}

void ChartPlot::setTitle(const QString& title, const QString& note) {
  m_title = title;
  m_note = note;
}

void ChartPlot::setLeastTime(double time) {
  m_leastTime = time;
}

void ChartPlot::setMostPoints(std::size_t most) {
  m_mostPoints = most;
}

void ChartPlot::setSubject(const ChartKind& kind, ChartSubject subject) {
  const bool isSameKind = m_kind == &kind;
  const bool isSameScene = subject.scene != nullptr && m_subject.scene == subject.scene;
  m_kind = &kind;
  m_subject = std::move(subject);
  if (!isSameKind) m_hidden = {};
  if (!isSameKind || !isSameScene) m_zoom.reset();
  rebuild();
}

void ChartPlot::setHidden(HiddenCurves hidden) {
  m_hidden = std::move(hidden);
  update();
}

void ChartPlot::setZoom(std::optional<QRectF> zoom) {
  m_zoom = zoom;
  update();
}

/// Curves carry colors and words: both may have changed.
void ChartPlot::rebuild() {
  m_content = m_kind->content(m_subject, m_frame->look().theme);
  m_caches.clear();
  m_amounts.clear();
  for (const ChartCurve& curve : m_content.curves) {
    m_caches.emplace_back(curve.points);
    m_amounts.push_back(curve.amounts ? std::optional(CurveCache(curve.amounts)) : std::nullopt);
  }
  update();
}

bool ChartPlot::hasNews() const {
  return std::ranges::any_of(m_caches, &CurveCache::hasNews);
}

void ChartPlot::update() {
  for (CurveCache& cache : m_caches) cache.read();
  for (std::optional<CurveCache>& amounts : m_amounts) {
    if (amounts) amounts->read();
  }
  m_extent = m_growing.of(m_subject.runs);
  findShown();
  m_range = m_zoom ? *m_zoom : wholeRange();
  showScales();
  showCurves();
}

bool ChartPlot::isShown(std::size_t curve) const {
  return m_hasValues[curve] && !m_hidden.holds(m_content.curves[curve]);
}

const CurveCache& ChartPlot::readable(std::size_t curve) const {
  return m_amounts[curve] ? *m_amounts[curve] : m_caches[curve];
}

const std::vector<DrawnCurve>& ChartPlot::drawn() const {
  return m_curves->curves();
}

const HeadingEntry* ChartPlot::entryAt(QPointF place) const {
  return m_frame->heading().entryAt(m_frame->heading().mapFromParent(place));
}

void ChartPlot::findShown() {
  m_hasValues.clear();
  for (const ChartCurve& curve : m_content.curves) {
    m_hasValues.push_back(!curve.quantity || m_extent.shown[*curve.quantity]);
  }
}

/// What the curves that are shown span, as they are drawn.
CurveExtent ChartPlot::extentOfAll() {
  CurveExtent all;
  for (std::size_t i = 0; i < m_caches.size(); ++i) {
    const ChartCurve& curve = m_content.curves[i];
    if (!isShown(i)) continue;
    // Energies have their ceiling, which says what it cuts off.
    const double until = m_content.energies ? kInfinity : m_extent.soundUntil[curve.run];
    CurveExtent extent = m_caches[i].extentUntil(until);
    if (curve.holdsPotential) {
      extent.lowestY -= offset();
      extent.highestY -= offset();
    }
    all.add(extent);
  }
  return all;
}

QRectF ChartPlot::wholeRange() {
  CurveExtent extent = extentOfAll();
  if (extent.isEmpty()) {
    extent.add(core::TimedPoint{0, 0, 0});
    extent.add(core::TimedPoint{0, 1, 1});
  }
  if (m_content.overTime) {
    extent.lowestX = 0;
    extent.highestX = std::max(extent.highestX, m_leastTime);
  }
  if (m_content.fromZero) {
    extent.lowestY = std::min(extent.lowestY, 0.0);
    extent.highestY *= kHeadroom;
    if (extent.lowestY >= extent.highestY) extent.highestY = extent.lowestY + 1;
  }
  if (m_content.energies && m_extent.ceiling) {
    extent.highestY = std::min(extent.highestY, *m_extent.ceiling);
  }
  if (!m_content.endsOnTicks) addMargins(extent, m_content.fromZero);
  widen(extent.lowestX, extent.highestX);
  widen(extent.lowestY, extent.highestY);
  const QRectF range(QPointF(extent.lowestX, extent.lowestY),
                     QPointF(extent.highestX, extent.highestY));
  return m_content.equalUnits ? withEqualUnits(range) : range;
}

/// Wider or higher, so that circles are round.
QRectF ChartPlot::withEqualUnits(QRectF range) const {
  const QSizeF plot = m_frame->plotSize();
  const double stretch = (plot.width() / range.width()) / (plot.height() / range.height());
  if (!(stretch > 1 / kMostStretch) || !(stretch < kMostStretch)) return range;
  const QPointF middle = range.center();
  if (stretch > 1) {
    range.setWidth(range.width() * stretch);
    range.moveCenter(middle);
  } else {
    range.setHeight(range.height() / stretch);
  }
  return range;
}

void ChartPlot::showScales() {
  const bool exact = m_zoom.has_value() || !m_content.endsOnTicks;
  const AxisEnds ends = exact ? AxisEnds::kExact : AxisEnds::kOnTicks;
  const auto scaled = m_content.overTime ? timeScale : axisScale;
  m_horizontal = scaled(m_content.horizontal, m_range.left(), m_range.right(),
                        m_frame->horizontalIntervals(), ends);
  m_vertical = axisScale(m_content.vertical, m_range.top(), m_range.bottom(),
                         m_frame->verticalIntervals(), ends);
  if (!exact) {
    const double x = m_horizontal.unit.size;
    const double y = m_vertical.unit.size;
    m_range = QRectF(QPointF(m_horizontal.lowest * x, m_vertical.lowest * y),
                     QPointF(m_horizontal.highest * x, m_vertical.highest * y));
  }
  HeadingContent heading = plotHeading(m_subject, m_content, m_hasValues, m_hidden, m_extent,
                                       m_vertical, m_frame->look().theme);
  heading.title = m_title;
  heading.note = m_note;
  m_frame->setHeading(std::move(heading));
  m_frame->setHorizontal(m_horizontal, m_content.horizontal.quantity);
  m_frame->setVertical(m_vertical, m_content.vertical.quantity);
}

void ChartPlot::showCurves() {
  std::size_t count = 0;
  for (std::size_t i = 0; i < m_caches.size(); ++i) count += isShown(i) ? 1 : 0;
  const std::size_t most = mostPointsPerCurve(count, m_mostPoints);
  std::vector<DrawnCurve> drawn;
  for (std::size_t i = 0; i < m_caches.size(); ++i) {
    if (isShown(i)) drawn.push_back(drawnCurve(i, most));
  }
  m_curves->setCurves(std::move(drawn), m_range);
}

DrawnCurve ChartPlot::drawnCurve(std::size_t index, std::size_t most) const {
  const ChartCurve& curve = m_content.curves[index];
  auto points = m_caches[index].points();
  if (m_content.overTime) points = partBetween(points, m_range.left(), m_range.right());
  const double shift = curve.holdsPotential ? offset() : 0;
  const QRectF range = m_range.translated(0, shift);

  DrawnCurve drawn;
  drawn.name = curve.name;
  drawn.run = m_subject.firstRun + curve.run;
  drawn.pen = runPen(curve.color, curve.width, drawn.run);
  drawn.lines = piecesInside(points, range, most);
  if (curve.style != CurveStyle::kLine) {
    drawn.areas = areasInside(points, curve.base, range, most);
    drawn.hatched = curve.style == CurveStyle::kHatched;
  }
  if (curve.style == CurveStyle::kBand) {
    const QRgb room = m_frame->look().theme.room.rgb();
    drawn.fill = QColor(mixed(curve.color.rgb(), room, kBandFaintness));
  }
  for (auto* polygons : {&drawn.lines, &drawn.areas}) {
    for (QPolygonF& polygon : *polygons) polygon.translate(0, -shift);
  }
  const QSizeF unit(m_frame->plotSize().width() / m_range.width(),
                    m_frame->plotSize().height() / m_range.height());
  const auto isAny = [&](auto isTooDense) {
    return std::ranges::any_of(drawn.lines,
                               [&](const QPolygonF& line) { return isTooDense(line, unit); });
  };
  drawn.dense = isAny(isTooDenseForSmoothLines);
  const bool noDashes = drawn.run > 0 && isAny(isTooDenseForDashes);
  if (drawn.dense || noDashes) drawn.pen = densePen(curve.color);
  return drawn;
}

}  // namespace ui
