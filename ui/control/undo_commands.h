#pragma once

#include <QObject>

class QAction;

namespace ui {

class Commands;
class SceneEditor;

/// Lets the commands undo and redo work, and say what they would undo or do again. A field in
/// which nothing was typed leaves their keys to the window.
class UndoCommands : public QObject {
  Q_OBJECT

 public:
  UndoCommands(const Commands& commands, SceneEditor* editor, QObject* parent);

 signals:
  /// Something was undone or done again, in words.
  void done(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void undo();
  void redo();
  void offerWhatCanBeDone();

  QAction* m_undo;
  QAction* m_redo;
  SceneEditor* m_editor;
};

}  // namespace ui
