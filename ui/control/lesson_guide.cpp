#include "ui/control/lesson_guide.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QTimer>

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
  connect(dock->toggleViewAction(), &QAction::toggled, this, [this, text](bool shown) {
    if (!m_sentence) text->setChecked(shown);
  });
  connect(dock->toggleViewAction(), &QAction::triggered, this, &LessonGuide::setTextShown);
  connect(commands.action(Command::kLessons), &QAction::triggered, this, &LessonGuide::openMenu);
  connect(editor, &SceneEditor::sceneReplaced, this, &LessonGuide::takeScene);
  connect(editor, &SceneEditor::sceneChanged, this, &LessonGuide::showText);
}

void LessonGuide::begin() {
  showText();
  m_dock->setVisible(!lesson().isEmpty() && lesson() != Settings().hiddenLesson());
  m_dock->raise();
  // With its final size the window goes back to the tabs it was left with, and raise() alone does
  // nothing to what it takes to be in front already.
  QTimer::singleShot(0, m_dock, [this] {
    m_dock->lower();
    m_dock->raise();
  });
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

void LessonGuide::present(QLabel* sentence) {
  const bool shown = !place()->isHidden();
  QAction* text = m_commands.action(Command::kLessonText);
  m_sentence = sentence;
  if (sentence) {
    sentence->setVisible(shown);
    showText();
    text->setChecked(shown);
  } else {
    text->setChecked(!m_dock->isHidden());
  }
}

QWidget* LessonGuide::place() const {
  return m_sentence ? static_cast<QWidget*>(m_sentence) : m_dock;
}

void LessonGuide::showText() {
  m_panel->showScene(*m_editor->scene());
  if (!m_sentence) return;
  const QString name = lesson();
  m_sentence->setText(name.isEmpty() ? QString::fromStdString(m_editor->scene()->description)
                                     : lessonNamed(name).look);
}

void LessonGuide::takeScene() {
  showText();
  if (lesson().isEmpty()) {
    place()->hide();
    m_commands.action(Command::kLessonText)->setChecked(false);
  } else {
    setTextShown(true);
  }
}

void LessonGuide::setTextShown(bool shown) {
  place()->setVisible(shown);
  if (shown && !m_sentence) m_dock->raise();
  m_commands.action(Command::kLessonText)->setChecked(shown);
  Settings().setHiddenLesson(shown ? QString() : lesson());
}

}  // namespace ui
