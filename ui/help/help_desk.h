#pragma once

#include <optional>

#include <QObject>
#include <QPointer>

#include "ui/help/help_window.h"
#include "ui/help/tour.h"

class QMainWindow;

namespace ui {

class Commands;
class SceneEditor;

/// Answers the help commands of a window: its guide, the model, the teacher's
/// sheets and the tour.
class HelpDesk : public QObject {
  Q_OBJECT

 public:
  /// @param window  the main window, which the tour leads through
  /// @param face    of the window in one language; what is shown goes with it
  HelpDesk(const Commands& commands, const SceneEditor* editor, QMainWindow* window, QWidget* face);
  ~HelpDesk() override;

  /// What is open in the book, if it is.
  std::optional<HelpWindow::Place> place() const;
  void open(const HelpWindow::Place& place) { book()->bringUp(place); }

 signals:
  /// Something was printed or saved, in words.
  void done(const QString& message);

 private:
  HelpWindow* book();
  void showSheet();

  const SceneEditor* m_editor;
  QMainWindow* m_window;
  QWidget* m_face;
  HelpWindow* m_book = nullptr;  // made when it is wanted first
  QPointer<Tour> m_tour;         // while it lasts
};

}  // namespace ui
