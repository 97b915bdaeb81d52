#pragma once

#include <vector>

#include <Qt>

class QDockWidget;
class QMainWindow;
class QMenu;
class QString;
class QWidget;

namespace ui {

class ChartsPanel;
class Commands;
class EventsPanel;
class LessonPanel;
class SceneArea;
class WeightsForm;
class WeightsTable;
class Workbench;

/// The panels around the scene: forms at its side, charts and tables below, each in a dock of
/// the window. Takes them out of the window again when it goes.
class WindowPanels {
 public:
  /// @param view  the scene, in which an opened step is shown
  WindowPanels(QMainWindow* window, const Workbench& bench, const Commands& commands,
               SceneArea* view);
  ~WindowPanels();
  WindowPanels(const WindowPanels&) = delete;
  WindowPanels& operator=(const WindowPanels&) = delete;

  ChartsPanel* charts() const { return m_charts; }
  EventsPanel* events() const { return m_events; }
  WeightsTable* table() const { return m_table; }
  LessonPanel* lesson() const { return m_lesson; }
  QDockWidget* chartsDock() const { return m_chartsDock; }
  QDockWidget* lessonDock() const { return m_lessonDock; }

  /// Adds a switch for each of them.
  void listIn(QMenu* menu) const;
  /// Gives each the room it has unless the user decides: scene and charts share the height.
  /// @param sceneHeight  [px]
  void sizeAsUsual(int sceneHeight) const;

 private:
  QDockWidget* add(Qt::DockWidgetArea area, const char* name, const QString& title,
                   QWidget* content);
  void addForms(const Workbench& bench, const Commands& commands);
  void addBelow(const Workbench& bench, const Commands& commands, SceneArea* view);
  void linkTable(const Commands& commands, QDockWidget* dock) const;

  QMainWindow* m_window;
  std::vector<QDockWidget*> m_docks;
  LessonPanel* m_lesson;
  WeightsForm* m_weights;
  ChartsPanel* m_charts;
  EventsPanel* m_events;
  WeightsTable* m_table;
  QDockWidget* m_lessonDock;
  QDockWidget* m_runsDock;
  QDockWidget* m_chartsDock;
};

}  // namespace ui
