#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include <QObject>

#include "core/trade/work_meter.h"

namespace ui {

/// Does one piece of long work at a time in another thread, and says how far it is.
class BackgroundTask : public QObject {
  Q_OBJECT

 public:
  /// What is done in the other thread. It is to end soon after the progress returns false.
  using Work = std::function<void(const core::Progress&)>;

  explicit BackgroundTask(QObject* parent = nullptr);
  /// Stops the work and waits until it has ended.
  ~BackgroundTask() override;

  /// @param done  called in this object's thread once the work has ended by itself
  /// @pre not isRunning()
  void start(Work work, std::function<void()> done);
  bool isRunning() const { return m_isRunning; }

 public slots:
  /// Lets the work end early; `done` is not called.
  void cancel();

 signals:
  void runningChanged(bool running);
  /// Another whole percent of the work is done.
  void progressed(int percent);
  /// The other thread's last word.
  void ended(QPrivateSignal);

 private:
  void end();

  std::jthread m_thread;
  std::function<void()> m_done;
  std::atomic<bool> m_isCancelled = false;
  bool m_isRunning = false;
};

}  // namespace ui
