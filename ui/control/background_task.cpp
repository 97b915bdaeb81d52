#include "ui/control/background_task.h"

#include <cassert>
#include <utility>

namespace ui {

BackgroundTask::BackgroundTask(QObject* parent) : QObject(parent) {
  connect(this, &BackgroundTask::ended, this, &BackgroundTask::end, Qt::QueuedConnection);
}

BackgroundTask::~BackgroundTask() {
  m_isCancelled = true;
  if (m_thread.joinable()) m_thread.join();
}

void BackgroundTask::start(Work work, std::function<void()> done) {
  assert(!m_isRunning);
  m_isRunning = true;
  m_isCancelled = false;
  m_done = std::move(done);
  emit runningChanged(true);
  emit progressed(0);
  m_thread = std::jthread([this, work = std::move(work)] {
    int shown = 0;
    work([this, &shown](double share) {
      const int percent = static_cast<int>(100 * share);
      if (percent != shown) emit progressed(percent);  // arrives in the receivers' thread
      shown = percent;
      return !m_isCancelled;
    });
    emit ended(QPrivateSignal());
  });
}

void BackgroundTask::cancel() {
  m_isCancelled = true;
}

void BackgroundTask::end() {
  m_thread.join();
  const std::function<void()> done = std::exchange(m_done, nullptr);
  m_isRunning = false;
  emit runningChanged(false);
  if (!m_isCancelled) done();
}

}  // namespace ui
