#include "ui/control/frame_ticker.h"

namespace ui {
namespace {

constexpr int kInterval = 16;  // ms

}  // namespace

FrameTicker::FrameTicker(QObject* parent) : QObject(parent) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(kInterval);
  connect(&m_timer, &QTimer::timeout, this, &FrameTicker::tick);
}

void FrameTicker::setRunning(bool running) {
  if (running == m_timer.isActive()) return;
  if (running) {
    m_sinceLast.start();
    m_timer.start();
  } else {
    m_timer.stop();
  }
}

void FrameTicker::tick() {
  const qint64 elapsed = m_sinceLast.nsecsElapsed();
  m_sinceLast.start();
  emit ticked(static_cast<double>(elapsed) * 1e-9);
}

}  // namespace ui
