#include "ui/control/recent_files.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMenu>

#include "ui/control/scene_files.h"
#include "ui/control/settings.h"

namespace ui {

RecentFiles::RecentFiles(SceneFiles* files, QMenu* menu)
    : QObject(menu), m_files(files), m_menu(menu) {
  menu->setToolTipsVisible(true);
  connect(menu, &QMenu::aboutToShow, this, &RecentFiles::list);
}

void RecentFiles::add(const QString& file) {
  if (file.isEmpty()) return;
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList files = Settings().recentFiles();
  files.removeAll(path);
  files.prepend(path);
  Settings().setRecentFiles(files.mid(0, kMost));
}

void RecentFiles::list() {
  m_menu->clear();
  const QStringList files = Settings().recentFiles();
  for (int i = 0; i < files.size(); ++i) {
    const QString& file = files[i];
    // An ampersand would be taken for a mark.
    const QString name = QFileInfo(file).fileName().replace('&', QStringLiteral("&&"));
    const QString words = QFileInfo::exists(file) ? name : tr("%1 (gone)").arg(name);
    const QString mark = i < 9 ? QStringLiteral("&%1  ").arg(i + 1) : QStringLiteral("1&0  ");
    QAction* action = m_menu->addAction(mark + words);
    action->setToolTip(QDir::toNativeSeparators(file));
    action->setStatusTip(action->toolTip());
    connect(action, &QAction::triggered, this, [this, file] { open(file); });
  }
  m_menu->addSeparator();
  QAction* clear = m_menu->addAction(tr("&Clear this list"));
  clear->setEnabled(!files.isEmpty());
  connect(clear, &QAction::triggered, this, [] { Settings().setRecentFiles({}); });
}

void RecentFiles::open(const QString& file) {
  if (QFileInfo::exists(file)) {
    m_files->leaveAndOpen(file);
    return;
  }
  QStringList files = Settings().recentFiles();
  files.removeAll(file);
  Settings().setRecentFiles(files);
  m_files->warnNotOpened(file, tr("The file is no longer there. It is taken off the list."));
}

}  // namespace ui
