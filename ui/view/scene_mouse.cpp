#include "ui/view/scene_mouse.h"

#include <QMouseEvent>

#include "ui/view/scene_view.h"

namespace ui {

namespace {

constexpr int kTremble = 4;  // px: a pointer that moves less than this clicks

}  // namespace

void SceneMouse::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return;
  m_isPressed = true;
  m_hasMoved = false;
  m_last = event.position();
  m_touch = m_hand ? m_hand->touch(*m_view, event.position()) : SceneHand::Touch::kNothing;
}

void SceneMouse::move(const QMouseEvent& event) {
  if (!m_isPressed) return showCursor(event.position());
  const QPointF way = event.position() - m_last;
  if (!m_hasMoved && way.manhattanLength() < kTremble) return;
  m_hasMoved = true;
  m_view->setCursor(Qt::ClosedHandCursor);
  if (m_touch == SceneHand::Touch::kHeld) {
    m_hand->drag(*m_view, event.position(), event.modifiers());
  } else {
    m_view->panBy(way);
    m_last = event.position();
  }
}

void SceneMouse::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !m_isPressed) return;
  m_isPressed = false;
  m_view->unsetCursor();
  m_felt = SceneHand::Touch::kNothing;
  if (m_hand) m_hand->release(m_touch, m_hasMoved);
  showCursor(event.position());
}

bool SceneMouse::pressAgain(const QMouseEvent& event) {
  press(event);
  return m_touch == SceneHand::Touch::kNothing;
}

/// Leaves the cursor alone where there is nothing to tell: others may have set it.
void SceneMouse::showCursor(QPointF pixel) {
  if (!m_hand) return;
  const SceneHand::Touch felt = m_hand->feel(*m_view, pixel);
  if (felt == m_felt) return;
  m_felt = felt;
  if (felt == SceneHand::Touch::kNothing) return m_view->unsetCursor();
  const bool canHold = felt == SceneHand::Touch::kHeld;
  m_view->setCursor(canHold ? Qt::OpenHandCursor : Qt::PointingHandCursor);
}

}  // namespace ui
