#pragma once

#include <QObject>
#include <QString>

class QMenu;

namespace ui {

class SceneFiles;

/// The menu of scene files that were opened or saved last, the latest first.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMost = 10;

  /// @param menu  is filled whenever it is about to be shown
  RecentFiles(SceneFiles* files, QMenu* menu);

  /// Puts a file at the top.
  static void add(const QString& file);

 private:
  void list();
  void open(const QString& file);

  SceneFiles* m_files;
  QMenu* m_menu;
};

}  // namespace ui
