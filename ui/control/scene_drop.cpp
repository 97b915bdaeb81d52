#include "ui/control/scene_drop.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <QWidget>

#include "ui/control/scene_files.h"

namespace ui {

SceneDrop::SceneDrop(SceneFiles* files, QWidget* window)
    : QObject(window), m_files(files), m_window(window) {
  window->setAcceptDrops(true);
  window->installEventFilter(this);
}

bool SceneDrop::eventFilter(QObject* watched, QEvent* event) {
  const bool isDrop = event->type() == QEvent::Drop;
  if (!isDrop && event->type() != QEvent::DragEnter && event->type() != QEvent::DragMove)
    return false;
  auto* drop = static_cast<QDropEvent*>(event);
  if (watched != m_window || !drop->mimeData()->hasUrls()) return false;
  drop->setDropAction(Qt::CopyAction);
  drop->accept();
  if (isDrop) take(*drop->mimeData());
  return true;
}

/// Later: whoever is dragging waits for the drop to end, and questions take their time.
void SceneDrop::take(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  const auto later = [this](auto action) {
    QMetaObject::invokeMethod(this, action, Qt::QueuedConnection);
  };
  const QString file = urls.first().toLocalFile();
  if (urls.size() > 1) {
    later([this, count = urls.size()] {
      m_files->warnNotOpened(tr("What was dropped"),
                             tr("These are %1 files. Drop one scene file.").arg(count));
    });
  } else if (file.isEmpty()) {
    later([this, url = urls.first()] {
      m_files->warnNotOpened(url.toDisplayString(), tr("It is no file on this computer."));
    });
  } else if (QFileInfo(file).isDir()) {
    later([this, file] { m_files->warnNotOpened(file, tr("It is a folder. Drop a scene file.")); });
  } else {
    later([this, file] { m_files->leaveAndOpen(file); });
  }
}

}  // namespace ui
