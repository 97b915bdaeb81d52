#include "ui/control/scene_loading.h"

#include <memory>

#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QLabel>
#include <QProgressDialog>

#include "ui/control/background_task.h"

namespace ui {
namespace {

// A file of this size is read before anybody could notice: 2000 weights, 20 ms.
constexpr qint64 kReadAtOnce = qint64{1} << 18;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneLoading)
};

/// Reads beside the window. Whatever the user does meanwhile is for the dialog.
SceneOrError readBeside(const QString& file, QWidget* window) {
  QProgressDialog dialog(Words::tr("Opening %1…").arg(QFileInfo(file).fileName()),
                         Words::tr("Cancel"), 0, 100, window);
  dialog.findChild<QLabel*>()->setTextFormat(Qt::PlainText);
  dialog.setWindowModality(Qt::ApplicationModal);
  dialog.setMinimumDuration(0);
  dialog.setAutoClose(false);
  dialog.setValue(0);
  SceneOrError read;
  BackgroundTask task;
  QEventLoop loop;
  QObject::connect(&task, &BackgroundTask::progressed, &dialog, &QProgressDialog::setValue);
  QObject::connect(&dialog, &QProgressDialog::canceled, &task, &BackgroundTask::cancel);
  task.start([&](const core::Progress& progress) { read = readSceneFile(file, progress); }, [] {});
  QObject::connect(&task, &BackgroundTask::runningChanged, &loop, &QEventLoop::quit);
  loop.exec();
  return dialog.wasCanceled() ? SceneOrError{} : read;
}

}  // namespace

SceneOrError readForWindow(const QString& file, QWidget* window) {
  const QString obstacle = obstacleToReading(file);
  if (!obstacle.isEmpty()) return {std::nullopt, obstacle};
  if (QFileInfo(file).size() < kReadAtOnce) return readSceneFile(file);
  return readBeside(file, window);
}

}  // namespace ui
