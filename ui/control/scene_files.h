#pragma once

#include <QObject>
#include <QString>

#include "core/scene/scene.h"
#include "ui/control/words.h"

class QWidget;

namespace ui {

class SceneEditor;

/// Opens and saves the scene of a window, and never loses one without asking. Remembers which
/// it was for the next start, and its file among the recent ones.
class SceneFiles : public QObject {
  Q_OBJECT

 public:
  /// @param file    where the scene came from; empty: from nowhere that can be saved to
  /// @param window  over which questions and messages appear
  SceneFiles(SceneEditor* editor, const QString& file, QWidget* window);

  /// Empty while the scene has no file.
  const QString& file() const;

  /// Asks about unsaved changes.
  /// @return  false if the user wants to stay with the scene
  bool mayLeaveScene();

  /// Asks about unsaved changes, then opens this file.
  void leaveAndOpen(const QString& file);
  /// Opens this file; if it is refused the present scene stays, and a message says why. A large
  /// one is read beside the window, which shows how far it is and lets the user give it up.
  void open(const QString& file);
  /// Says that something was not opened, and why.
  void warnNotOpened(const QString& file, const QString& reason);
  /// @return  false if it could not be saved, which a message has said
  bool saveTo(const QString& file);

 public slots:
  /// One weight in an empty room.
  void startNew();
  void askAndOpen();
  /// @pre name is one of builtInScenes()
  void openBuiltIn(const QString& name);
  bool save();
  bool saveAs();

 signals:
  /// Something went well, in words.
  void done(const QString& message);

 private:
  static Words openingWords(const Words& name);
  void remember();

  SceneEditor* m_editor;
  QWidget* m_window;
};

}  // namespace ui
