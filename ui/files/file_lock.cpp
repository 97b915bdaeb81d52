#include "ui/files/file_lock.h"

#include <QFile>
#include <QLockFile>

namespace ui {

bool lockNow(QLockFile& lock) {
  return lock.tryLock(0) || (lock.removeStaleLockFile() && lock.tryLock(0));
}

void freeSettingsOfTheDead(const QString& settingsFile) {
  const QString lock = settingsFile + QStringLiteral(".lock");
  if (QFile::exists(lock)) QLockFile(lock).removeStaleLockFile();
}

}  // namespace ui
