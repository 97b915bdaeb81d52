#include "ui/chart/redraw_limiter.h"

namespace ui {

RedrawLimiter::RedrawLimiter(int shortestPause, QObject* parent)
    : QObject(parent), m_shortestPause(shortestPause) {
  m_catchUp.setSingleShot(true);
  connect(&m_catchUp, &QTimer::timeout, this, &RedrawLimiter::hurry);
}

void RedrawLimiter::request() {
  if (m_catchUp.isActive()) return;
  const qint64 waited = m_sinceDue.isValid() ? m_sinceDue.elapsed() : m_shortestPause;
  if (waited >= m_shortestPause) {
    hurry();
  } else {
    m_catchUp.start(static_cast<int>(m_shortestPause - waited));
  }
}

void RedrawLimiter::hurry() {
  m_catchUp.stop();
  m_sinceDue.start();
  emit due();
}

}  // namespace ui
