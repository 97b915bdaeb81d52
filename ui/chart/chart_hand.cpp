#include "ui/chart/chart_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QChart>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/chart/chart_plot.h"
#include "ui/chart/chart_readings.h"
#include "ui/chart/chart_zoom.h"
#include "ui/chart/curves_item.h"

namespace ui {

namespace {

constexpr double kWheelFactor = 1.2;  // for each notch
constexpr double kKeyFactor = 1.5;
constexpr double kKeyMove = 0.1;      // of what is shown
constexpr double kGrabDistance = 7;   // [px]
constexpr double kClickDistance = 5;  // a drag is longer [px]
constexpr double kReadDistance = 40;  // from a curve that is not over time [px]

struct KeyMove {
  int key;
  double x;
  double y;
};

constexpr std::array kKeyMoves = {
    KeyMove{Qt::Key_Left, -kKeyMove, 0}, KeyMove{Qt::Key_Right, kKeyMove, 0},
    KeyMove{Qt::Key_Down, 0, -kKeyMove}, KeyMove{Qt::Key_Up, 0, kKeyMove}};

const KeyMove* moveOf(const QKeyEvent& event) {
  if (!event.modifiers().testFlag(Qt::AltModifier)) return nullptr;
  const auto* move = std::ranges::find(kKeyMoves, event.key(), &KeyMove::key);
  return move == kKeyMoves.end() ? nullptr : move;
}

}  // namespace

ChartHand::ChartHand(QChart* chart, ChartPlot* plot, QObject* parent)
    : QObject(parent), m_chart(chart), m_plot(plot) {}

void ChartHand::showTime(double time) {
  if (m_overlay.shownTime == time) return;
  m_overlay.shownTime = time;
  emit overlayChanged();
}

QRectF ChartHand::plotArea() const {
  return m_chart->plotArea();
}

void ChartHand::zoomIn() {
  zoomAt(plotArea().center(), kKeyFactor, kKeyFactor);
}

void ChartHand::zoomOut() {
  zoomAt(plotArea().center(), 1 / kKeyFactor, 1 / kKeyFactor);
}

void ChartHand::resetZoom() {
  m_plot->setZoom(std::nullopt);
  emit plotChanged();
}

/// Shows just this range, or all where that is no more.
void ChartHand::zoomTo(const QRectF& range) {
  if (!canBeShown(range)) return;
  const bool isAll = range.contains(m_plot->wholeRange());
  m_plot->setZoom(isAll ? std::nullopt : std::optional(range));
  emit plotChanged();
}

void ChartHand::zoomAt(QPointF place, double factorX, double factorY) {
  zoomTo(zoomedAbout(m_plot->range(), valuesAt(place), factorX, factorY));
}

QPointF ChartHand::valuesAt(QPointF place) const {
  return plotTransform(m_plot->range(), plotArea()).inverted().map(place);
}

/// The moment a place stands for: that of the time axis, or of the nearest point.
std::optional<double> ChartHand::timeAt(QPointF place) const {
  const QPointF values = valuesAt(place);
  if (m_plot->content().overTime) return std::max(0.0, values.x());
  const QSizeF unit(plotArea().width() / m_plot->range().width(),
                    plotArea().height() / m_plot->range().height());
  return nearestTime(*m_plot, values, unit, kReadDistance);
}

bool ChartHand::isOnTimeLine(QPointF place) const {
  if (!m_overlay.shownTime || !m_plot->content().overTime) return false;
  const QTransform toPlot = plotTransform(m_plot->range(), plotArea());
  const double x = toPlot.map(QPointF(*m_overlay.shownTime, 0)).x();
  const QRectF grip = plotArea().adjusted(0, -2 * kGrabDistance, 0, 0);
  return std::abs(place.x() - x) <= kGrabDistance && grip.top() <= place.y() &&
         place.y() <= grip.bottom();
}

void ChartHand::toggleEntryAt(QPointF place) {
  const HeadingEntry* entry = m_plot->entryAt(place);
  if (entry == nullptr) return;
  HiddenCurves hidden = m_plot->hidden();
  const auto toggle = [](auto& set, const auto& key) {
    if (set.erase(key) == 0) set.insert(key);
  };
  if (entry->key.isEmpty()) {
    toggle(hidden.runs, entry->run);
  } else {
    toggle(hidden.names, entry->key);
  }
  m_plot->setHidden(std::move(hidden));
  emit plotChanged();
}

void ChartHand::pickAt(QPointF place) {
  if (const auto time = timeAt(place)) emit timePicked(*time);
}

void ChartHand::readAt(QPointF place) {
  m_overlay.pointer = place;
  m_overlay.readTime = plotArea().contains(place) ? timeAt(place) : std::nullopt;
  emit overlayChanged();
}

void ChartHand::feel(QPointF place) {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (isOnTimeLine(place)) {
    shape = Qt::SplitHCursor;
  } else if (m_plot->entryAt(place) != nullptr) {
    shape = Qt::PointingHandCursor;
  } else if (plotArea().contains(place)) {
    shape = Qt::CrossCursor;
  }
  emit cursorWanted(shape);
}

void ChartHand::finishBox() {
  const QRectF box = m_overlay.box.intersected(plotArea());
  m_overlay.box = {};
  emit overlayChanged();
  if (box.width() < kClickDistance || box.height() < kClickDistance) return;
  const QRectF range = QRectF(valuesAt(box.topLeft()), valuesAt(box.bottomRight())).normalized();
  zoomTo(range);
}

bool ChartHand::press(const QMouseEvent& event) {
  const QPointF place = event.position();
  const bool moves = event.button() == Qt::MiddleButton ||
                     (event.button() == Qt::LeftButton && event.modifiers() & Qt::ShiftModifier);
  m_dragStart = place;
  m_rangeAtStart = m_plot->range();
  if (moves && plotArea().contains(place)) {
    m_drag = Drag::kMove;
    emit cursorWanted(Qt::ClosedHandCursor);
  } else if (event.button() != Qt::LeftButton) {
    return false;
  } else if (isOnTimeLine(place)) {
    m_drag = Drag::kTime;
  } else if (plotArea().contains(place)) {
    m_drag = Drag::kBox;
  } else {
    toggleEntryAt(place);
  }
  return true;
}

void ChartHand::move(const QMouseEvent& event) {
  const QPointF place = event.position();
  const QPointF way = place - m_dragStart;
  switch (m_drag) {
    case Drag::kNone:
      readAt(place);
      feel(place);
      break;
    case Drag::kTime:
      m_overlay.readTime.reset();
      pickAt(place);
      break;
    case Drag::kBox:
      m_overlay.readTime.reset();
      m_overlay.box = QRectF(m_dragStart, place).normalized().intersected(plotArea());
      emit overlayChanged();
      break;
    case Drag::kMove:
      zoomTo(movedBy(m_rangeAtStart, -way.x() / plotArea().width(), way.y() / plotArea().height()));
      break;
  }
}

void ChartHand::release(const QMouseEvent& event) {
  const QPointF place = event.position();
  const Drag drag = std::exchange(m_drag, Drag::kNone);
  const bool isClick = (place - m_dragStart).manhattanLength() < kClickDistance;
  if (drag == Drag::kBox && isClick) pickAt(place);
  if (drag == Drag::kBox) finishBox();
  feel(place);
}

void ChartHand::pressAgain(const QMouseEvent& event) {
  if (event.button() == Qt::LeftButton && plotArea().contains(event.position())) resetZoom();
}

void ChartHand::turnWheel(const QWheelEvent& event) {
  const QPointF place = event.position();
  const double factor = std::pow(kWheelFactor, event.angleDelta().y() / 120.0);
  // Beside an axis only along it.
  const bool alongX = place.x() >= plotArea().left() && !(event.modifiers() & Qt::ControlModifier);
  const bool alongY = place.y() <= plotArea().bottom() && !(event.modifiers() & Qt::ShiftModifier);
  zoomAt(place, alongX ? factor : 1, alongY ? factor : 1);
}

void ChartHand::stopReading() {
  m_overlay.readTime.reset();
  emit overlayChanged();
}

bool ChartHand::wants(const QKeyEvent& event) const {
  if (moveOf(event) != nullptr) return true;
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
  switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_0:
      return true;
    case Qt::Key_Escape:
      return m_plot->zoom().has_value();
    default:
      return false;
  }
}

void ChartHand::pressKey(const QKeyEvent& event) {
  if (const KeyMove* move = moveOf(event)) {
    zoomTo(movedBy(m_plot->range(), move->x, move->y));
  } else if (event.key() == Qt::Key_Plus || event.key() == Qt::Key_Equal) {
    zoomIn();
  } else if (event.key() == Qt::Key_Minus) {
    zoomOut();
  } else {
    resetZoom();
  }
}

}  // namespace ui
