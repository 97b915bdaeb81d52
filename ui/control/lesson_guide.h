#pragma once

#include <QObject>
#include <QString>

class QDockWidget;
class QLabel;
class QWidget;

namespace ui {

class Commands;
class LessonChooser;
class LessonPanel;
class SceneEditor;
class SceneFiles;

/// Lets lessons be chosen, and keeps their text beside the scene: it comes with each lesson
/// that is opened, goes with scenes that are nobody's lesson, and stays away from a lesson it
/// was sent away from, at the next start too.
class LessonGuide : public QObject {
  Q_OBJECT

 public:
  /// @param dock    holds `panel`
  /// @param window  the menu of pictures stands before it, and the parent
  LessonGuide(const Commands& commands, SceneEditor* editor, SceneFiles* files, LessonPanel* panel,
              QDockWidget* dock, QWidget* window);

  /// Shows the text of the scene the window starts with, if it has one and was not sent away.
  void begin();
  /// Shows the text of the scene, if it has one, where there is a place for it.
  void showText();

  /// Shows the sentence in this label, wanted or not as it was, in place of the panel; null:
  /// in the panel again.
  void present(QLabel* sentence);

 private:
  void openMenu();
  void takeScene();
  void setTextShown(bool shown);
  QWidget* place() const;
  QString lesson() const;

  const Commands& m_commands;
  SceneEditor* m_editor;
  SceneFiles* m_files;
  LessonPanel* m_panel;
  QDockWidget* m_dock;
  QWidget* m_window;
  QLabel* m_sentence = nullptr;     // while presenting
  LessonChooser* m_menu = nullptr;  // made when it is wanted first
};

}  // namespace ui
