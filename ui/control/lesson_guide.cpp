#include "ui/control/lesson_guide.h"

#include <QAction>
#include <QDockWidget>

#include "ui/control/commands.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/lessons.h"
#include "ui/panels/lesson_chooser.h"
#include "ui/panels/lesson_panel.h"

namespace ui {

LessonGuide::LessonGuide(const Commands& commands, SceneEditor* editor, SceneFiles* files,
                         LessonPanel* panel, QDockWidget* dock, QWidget* window)
    : QObject(window),
      m_commands(commands),
      m_editor(editor),
      m_files(files),
      m_panel(panel),
      m_dock(dock),
      m_window(window) {
  QAction* text = commands.action(Command::kLessonText);
  connect(text, &QAction::triggered, this, &LessonGuide::setTextShown);
  connect(dock->toggleViewAction(), &QAction::toggled, text, &QAction::setChecked);
  connect(dock->toggleViewAction(), &QAction::triggered, this, &LessonGuide::setTextShown);
  connect(commands.action(Command::kLessons), &QAction::triggered, this, &LessonGuide::openMenu);
  connect(editor, &SceneEditor::sceneReplaced, this, &LessonGuide::takeScene);
  connect(editor, &SceneEditor::sceneChanged, this,
          [this] { m_panel->showScene(*m_editor->scene()); });
}

void LessonGuide::begin() {
  m_panel->showScene(*m_editor->scene());
  m_dock->setVisible(!lesson().isEmpty() && lesson() != Settings().hiddenLesson());
  m_dock->raise();
}

QString LessonGuide::lesson() const {
  return lessonNameOf(*m_editor->scene());
}

void LessonGuide::openMenu() {
  if (!m_menu) {
    m_menu = new LessonChooser(m_window);
    connect(m_menu, &LessonChooser::chosen, m_files, &SceneFiles::openBuiltIn);
  }
  m_menu->bringUp(lesson());
}

void LessonGuide::takeScene() {
  if (lesson().isEmpty()) {
    m_dock->hide();
  } else {
    setTextShown(true);
  }
}

void LessonGuide::setTextShown(bool shown) {
  m_dock->setVisible(shown);
  if (shown) m_dock->raise();
  Settings().setHiddenLesson(shown ? QString() : lesson());
}

}  // namespace ui
