#pragma once

#include <functional>

#include <QObject>
#include <QStringList>

class QMenu;
class QMenuBar;

namespace ui {

class Commands;

/// The menus of the window. What a menu cannot know, it says by signals.
class MainMenu : public QObject {
  Q_OBJECT

 public:
  MainMenu(QMenuBar* bar, const Commands& commands);

  /// Where the panels' switches belong.
  QMenu* panels() const { return m_panels; }
  /// Where the files opened last belong.
  QMenu* recentFiles() const { return m_recent; }

  /// Offers one choice of several under a heading in the view menu.
  void addChoice(const QString& title, const QStringList& words, int chosen,
                 const std::function<void(int)>& choose);

  /// Names of the runs whose ledgers can be exported.
  void setRuns(const QStringList& names);

 signals:
  void builtInChosen(const QString& name);
  void ledgerChosen(int run);

 private:
  void addFileMenu(QMenuBar* bar, const Commands& commands);
  void addEditMenu(QMenuBar* bar, const Commands& commands);
  void addRunMenu(QMenuBar* bar, const Commands& commands);
  void addGoToMenu(QMenu* menu, const Commands& commands);
  void addViewMenu(QMenuBar* bar, const Commands& commands);
  void addWeightMenu(QMenuBar* bar, const Commands& commands);
  void addChartMenu(QMenuBar* bar, const Commands& commands);
  void addHelpMenu(QMenuBar* bar, const Commands& commands);
  static void addButtons(QMenuBar* bar, const Commands& commands);
  void listBuiltInScenes();

  QMenu* m_scenes;
  QMenu* m_recent;
  QMenu* m_ledgers;
  QMenu* m_view;
  QMenu* m_panels;
};

}  // namespace ui
