#include "ui/help/help_desk.h"

#include <QAction>
#include <QMainWindow>

#include "ui/control/commands.h"
#include "ui/control/scene_editor.h"
#include "ui/files/lessons.h"

namespace ui {

HelpDesk::HelpDesk(const Commands& commands, const SceneEditor* editor, QMainWindow* window,
                   QWidget* face)
    : QObject(face), m_editor(editor), m_window(window), m_face(face) {
  const auto on = [&](Command command, auto answer) {
    connect(commands.action(command), &QAction::triggered, this, answer);
  };
  on(Command::kGuide, [this] { book()->bringUp(HelpWindow::Chapter::kGuide); });
  on(Command::kModel, [this] { book()->bringUp(HelpWindow::Chapter::kModel); });
  on(Command::kSheet, &HelpDesk::showSheet);
  on(Command::kTour, [this] { m_tour = m_tour ? m_tour.data() : new Tour(m_window); });
}

HelpDesk::~HelpDesk() {
  delete m_tour;
}

std::optional<HelpWindow::Place> HelpDesk::place() const {
  if (!m_book || !m_book->isVisible()) return std::nullopt;
  return m_book->place();
}

HelpWindow* HelpDesk::book() {
  if (!m_book) {
    m_book = new HelpWindow(m_face);
    connect(m_book, &HelpWindow::said, this, &HelpDesk::done);
  }
  return m_book;
}

void HelpDesk::showSheet() {
  const QString lesson = lessonNameOf(*m_editor->scene());
  if (lesson.isEmpty()) {
    book()->bringUp(HelpWindow::Chapter::kSheets);
  } else {
    book()->bringUpSheet(lesson);
  }
}

}  // namespace ui
