#include "ui/view/camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ui {

void Camera::setViewport(QSizeF size, double devicePixelRatio) {
  assert(size.width() > 0 && size.height() > 0 && devicePixelRatio > 0);
  m_viewport = size;
  m_devicePixelRatio = devicePixelRatio;
}

void Camera::fit(QSizeF room, QMarginsF margins) {
  assert(room.width() > 0 && room.height() > 0);
  // A window squeezed to less than its margins still needs a scale above zero.
  const double width = std::max(m_viewport.width() - margins.left() - margins.right(), 1.0);
  const double height = std::max(m_viewport.height() - margins.top() - margins.bottom(), 1.0);
  m_room = room;
  m_scale = m_fittedScale = std::min(width / room.width(), height / room.height());
  m_center = QPointF(room.width() / 2 + (margins.right() - margins.left()) / 2 / m_scale,
                     room.height() / 2 + (margins.top() - margins.bottom()) / 2 / m_scale);
}

void Camera::zoomAt(QPointF pixel, double factor) {
  assert(factor > 0);
  const Eigen::Vector2d before = toMetres(pixel);
  const double largest = std::max(kLargestScale, m_fittedScale);
  m_scale = std::clamp(m_scale * factor, m_fittedScale * kSmallestShare, largest);
  const Eigen::Vector2d after = toMetres(pixel);
  m_center += QPointF(before.x() - after.x(), before.y() - after.y());
  keepCenterInRoom();
}

void Camera::panBy(QPointF pixels) {
  m_center += QPointF(-pixels.x(), pixels.y()) / m_scale;
  keepCenterInRoom();
}

void Camera::keepCenterInRoom() {
  m_center.setX(std::clamp(m_center.x(), 0.0, m_room.width()));
  m_center.setY(std::clamp(m_center.y(), 0.0, m_room.height()));
}

QPointF Camera::toPixels(const Eigen::Vector2d& metres) const {
  return {m_viewport.width() / 2 + (metres.x() - m_center.x()) * m_scale,
          m_viewport.height() / 2 - (metres.y() - m_center.y()) * m_scale};
}

Eigen::Vector2d Camera::toMetres(QPointF pixel) const {
  return {m_center.x() + (pixel.x() - m_viewport.width() / 2) / m_scale,
          m_center.y() - (pixel.y() - m_viewport.height() / 2) / m_scale};
}

QRectF Camera::visibleMetres() const {
  const Eigen::Vector2d corner = toMetres({0, m_viewport.height()});
  return {QPointF(corner.x(), corner.y()), m_viewport / m_scale};
}

double Camera::snapped(double pixel) const {
  return std::round(pixel * m_devicePixelRatio) / m_devicePixelRatio;
}

}  // namespace ui
