#pragma once

#include <QObject>

class QAction;

namespace ui {

class Commands;
class SceneEditor;

/// Lets the commands undo and redo work, and say what they would undo or do again.
class UndoCommands : public QObject {
  Q_OBJECT

 public:
  UndoCommands(const Commands& commands, SceneEditor* editor, QObject* parent);

 signals:
  /// Something was undone or done again, in words.
  void done(const QString& message);

 private:
  void undo();
  void redo();
  void offerWhatCanBeDone();

  QAction* m_undo;
  QAction* m_redo;
  SceneEditor* m_editor;
};

}  // namespace ui
