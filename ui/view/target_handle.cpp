#include "ui/view/target_handle.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>

#include "ui/view/camera.h"
#include "ui/view/scene_view.h"
#include "ui/view/target_drawing.h"

namespace ui {

namespace {

constexpr double kReach = 8;          // around the stripe [px]
constexpr double kEnd = 6;            // of an end, to both sides [px]
constexpr double kLeastForEnds = 40;  // width of a target whose ends can be told apart [px]
constexpr double kLeastWidth = 1e-3;  // of the room's

}  // namespace

TargetHandle::TargetHandle(SceneView* view) : QObject(view), m_view(view) {
  view->setMouseTracking(true);
  view->installEventFilter(this);
}

bool TargetHandle::eventFilter(QObject* watched, QEvent* event) {
  // Others come as well when the view is being taken down, and is no view any more.
  const bool isOfMouse =
      QEvent::MouseButtonPress <= event->type() && event->type() <= QEvent::MouseMove;
  if (!isOfMouse || !m_view->target()) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return drag(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
      return partAt(static_cast<QMouseEvent&>(*event).position()).has_value();
    default:
      return QObject::eventFilter(watched, event);
  }
}

std::optional<TargetHandle::Part> TargetHandle::partAt(QPointF pixel) const {
  const QRectF stripe = targetStripe(m_view->target()->place, m_view->room(), m_view->camera());
  if (!stripe.adjusted(-kReach, -kReach, kReach, kReach).contains(pixel)) return std::nullopt;
  if (stripe.width() < kLeastForEnds) return Part::kMiddle;
  if (std::abs(pixel.x() - stripe.left()) <= kEnd) return Part::kWestEnd;
  if (std::abs(pixel.x() - stripe.right()) <= kEnd) return Part::kEastEnd;
  return Part::kMiddle;
}

bool TargetHandle::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  m_dragged = partAt(event.position());
  m_before = m_view->target()->place;
  m_takenAt = m_view->camera().toMetres(event.position()).x();
  return m_dragged.has_value();
}

bool TargetHandle::drag(const QMouseEvent& event) {
  if (!m_dragged) {
    if (event.buttons() == Qt::NoButton) showCursor(event.position());
    return false;
  }
  const double way = m_view->camera().toMetres(event.position()).x() - m_takenAt;
  const double roomWidth = m_view->room().width;
  core::Target target = m_before;
  if (*m_dragged == Part::kMiddle) {
    target.center = std::clamp(rounded(m_before.center + way), 0.0, roomWidth);
  } else {
    const double wider = *m_dragged == Part::kEastEnd ? way : -way;
    target.width =
        std::clamp(rounded(m_before.width + 2 * wider), kLeastWidth * roomWidth, roomWidth);
  }
  emit moved(target);
  return true;
}

bool TargetHandle::release(const QMouseEvent& event) {
  if (!m_dragged || event.button() != Qt::LeftButton) return false;
  m_dragged.reset();
  return true;
}

/// As exact as a pixel can mean, in few digits.
double TargetHandle::rounded(double metres) const {
  const double digit = std::pow(10, std::floor(std::log10(1 / m_view->camera().scale())));
  return std::round(metres / digit) * digit;
}

/// Over the target another one than the view's own.
void TargetHandle::showCursor(QPointF pixel) {
  const auto part = partAt(pixel);
  if (part) {
    m_view->setCursor(*part == Part::kMiddle ? Qt::OpenHandCursor : Qt::SizeHorCursor);
  } else if (m_hasCursor) {
    m_view->unsetCursor();
  }
  m_hasCursor = part.has_value();
}

}  // namespace ui
