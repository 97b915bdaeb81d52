#include "ui/control/draft_keeper.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include "ui/control/scene_editor.h"
#include "ui/files/draft_file.h"

namespace ui {
namespace {

QString newFileIn(const QString& folder) {
  return QDir(folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + ".draft");
}

}  // namespace

QString draftFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/angrycuts/drafts");
}

QString DraftKeeper::lockOf(const QString& draftFile) {
  return draftFile + QStringLiteral(".lock");
}

DraftKeeper::DraftKeeper(const SceneEditor* editor, const QString& folder,
                         std::chrono::milliseconds delay, QObject* parent)
    : QObject(parent),
      m_editor(editor),
      m_file(newFileIn(folder)),
      m_lock(lockOf(m_file)),
      m_task(std::make_unique<BackgroundTask>()) {
  // Only an owner that is gone gives it up, however long a lesson takes.
  m_lock.setStaleLockTime(0);
  m_timer.setSingleShot(true);
  m_timer.setInterval(delay);
  connect(&m_timer, &QTimer::timeout, this, &DraftKeeper::keepNow);
  connect(editor, &SceneEditor::draftChanged, this, &DraftKeeper::follow);
  connect(editor, &SceneEditor::modifiedChanged, this, &DraftKeeper::follow);
}

DraftKeeper::~DraftKeeper() {
  m_task.reset();
  if (!m_isWanted) remove();
}

/// Not put off by further changes: the first that is not kept decides when.
void DraftKeeper::follow() {
  if (!m_editor->isModified()) {
    letGo();
  } else if (!m_timer.isActive()) {
    m_timer.start();
  }
}

DraftKeeper::Content DraftKeeper::content() const {
  Content content{m_editor->file(), m_editor->scene(), std::nullopt};
  if (!m_editor->problems().empty()) content.draft = m_editor->draft();
  return content;
}

/// @return empty, or why nothing can be written there
QString DraftKeeper::prepare() {
  const QString folder = QFileInfo(m_file).absolutePath();
  if (!QDir().mkpath(folder)) return tr("the folder %1 cannot be made").arg(folder);
  if (m_lock.isLocked() || m_lock.tryLock(0)) return {};
  return tr("nothing can be written to %1").arg(folder);
}

void DraftKeeper::keepNow() {
  m_timer.stop();
  if (!m_editor->isModified()) return;
  if (m_task->isRunning()) {
    m_timer.start();
    return;
  }
  const Content now = content();
  if (m_written == now) return;
  const QString obstacle = prepare();
  if (!obstacle.isEmpty()) {
    note(now, obstacle);
    return;
  }
  m_isWanted = true;
  const auto error = std::make_shared<QString>();
  m_task->start(
      [now, error, file = m_file](const core::Progress&) {
        *error = writeDraftFile(file, {now.file, *now.scene, now.draft});
      },
      [this, now, error] { note(now, *error); });
}

bool DraftKeeper::keepAndWait() {
  if (!m_editor->isModified() || m_task->isRunning()) return false;
  const Content now = content();
  QString error = prepare();
  if (error.isEmpty()) error = writeDraftFile(m_file, {now.file, *now.scene, now.draft});
  m_isWanted = true;
  note(now, error);
  return error.isEmpty();
}

void DraftKeeper::note(const Content& written, const QString& error) {
  m_written.reset();
  if (error.isEmpty()) m_written = written;
  if (!m_isWanted) remove();
  if (!error.isEmpty() && !m_hasFailed) emit failed(error);
  m_hasFailed = !error.isEmpty();
}

void DraftKeeper::letGo() {
  m_timer.stop();
  m_isWanted = false;
  if (!m_task->isRunning()) remove();
}

void DraftKeeper::remove() {
  m_written.reset();
  if (!m_lock.isLocked()) return;
  QFile::remove(m_file);
  m_lock.unlock();
}

}  // namespace ui
