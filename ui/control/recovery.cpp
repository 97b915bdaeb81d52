#include "ui/control/recovery.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QLockFile>

#include "ui/control/draft_keeper.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/draft_file.h"
#include "ui/files/file_lock.h"
#include "ui/files/lessons.h"

namespace ui {
namespace {

QString nameOf(const KeptDraft& kept) {
  return kept.file.isEmpty() ? titleOf(kept.scene) : QFileInfo(kept.file).fileName();
}

}  // namespace

Recovery::Recovery(SceneEditor* editor, SceneFiles* files, DraftKeeper* keeper,
                   const QString& folder, QObject* parent)
    : QObject(parent), m_editor(editor), m_files(files), m_keeper(keeper), m_folder(folder) {}

Recovery::~Recovery() = default;

void Recovery::start() {
  for (const QFileInfo& file :
       QDir(m_folder).entryInfoList({"*.draft"}, QDir::Files, QDir::Time | QDir::Reversed))
    m_found << file.absoluteFilePath();
  offerNext();
}

void Recovery::offerNext() {
  m_lock.reset();
  m_kept.reset();
  while (!m_found.isEmpty() && !take(m_found.takeLast())) {
  }
  offerAgain();
}

void Recovery::offerAgain() {
  if (!m_kept) {
    emit offered({});
    return;
  }
  const QString name = nameOf(*m_kept);
  const QDateTime time = QFileInfo(m_file).lastModified();
  emit offered(tr("The program ended before changes of %1 were saved, on %2.")
                   .arg(name.isEmpty() ? tr("a new scene") : name,
                        QLocale().toString(time, QLocale::ShortFormat)));
}

/// Makes it the draft that is offered, unless another program works on it or it cannot be
/// read: then it is left as it is.
bool Recovery::take(const QString& file) {
  auto lock = std::make_unique<QLockFile>(DraftKeeper::lockOf(file));
  lock->setStaleLockTime(0);
  if (!lockNow(*lock)) return false;
  std::optional<KeptDraft> kept = readDraftFile(file);
  if (!kept) return false;
  m_file = file;
  m_lock = std::move(lock);
  m_kept = std::make_unique<KeptDraft>(std::move(*kept));
  return true;
}

void Recovery::bringBack() {
  if (!m_kept || !m_files->mayLeaveScene()) return;
  m_editor->restore(m_kept->scene, m_kept->draft, m_kept->file,
                    [] { return tr("recovery of changes"); });
  // The old file goes when the changes are safe in a new one.
  if (m_keeper->keepAndWait()) removeOffered();
  offerNext();
}

void Recovery::discard() {
  if (!m_kept) return;
  removeOffered();
  offerNext();
}

void Recovery::removeOffered() {
  QFile::remove(m_file);
}

}  // namespace ui
