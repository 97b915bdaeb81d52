#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui {

/// The window's heartbeat: about sixty times a second it tells how much wall time passed.
class FrameTicker : public QObject {
  Q_OBJECT

 public:
  explicit FrameTicker(QObject* parent = nullptr);

 public slots:
  /// Time while it does not run is not told afterwards.
  void setRunning(bool running);

 signals:
  /// @param elapsed  wall time since the last tick, or since the start [s]
  void ticked(double elapsed);

 private:
  void tick();

  QTimer m_timer;
  QElapsedTimer m_sinceLast;
};

}  // namespace ui
