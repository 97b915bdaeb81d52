#include "ui/control/undo_commands.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>

#include "ui/control/commands.h"
#include "ui/control/scene_editor.h"

namespace ui {
namespace {

/// Where the widget takes text; null: it takes none.
const QLineEdit* lineOf(QObject* widget) {
  if (const auto* box = qobject_cast<QAbstractSpinBox*>(widget))
    return box->findChild<QLineEdit*>();
  return qobject_cast<QLineEdit*>(widget);
}

}  // namespace

UndoCommands::UndoCommands(const Commands& commands, SceneEditor* editor, QObject* parent)
    : QObject(parent),
      m_undo(commands.action(Command::kUndo)),
      m_redo(commands.action(Command::kRedo)),
      m_editor(editor) {
  connect(m_undo, &QAction::triggered, this, &UndoCommands::undo);
  connect(m_redo, &QAction::triggered, this, &UndoCommands::redo);
  connect(editor, &SceneEditor::historyChanged, this, &UndoCommands::offerWhatCanBeDone);
  offerWhatCanBeDone();
  qApp->installEventFilter(this);
}

bool UndoCommands::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
  const QLineEdit* line = lineOf(watched);
  if (!line || line->isUndoAvailable() || line->isRedoAvailable()) return false;
  event->ignore();
  return true;
}

void UndoCommands::undo() {
  const QString words = m_editor->undoWords();
  m_editor->undo();
  emit done(words.isEmpty() ? tr("Undone") : tr("Undone: %1").arg(words));
}

void UndoCommands::redo() {
  const QString words = m_editor->redoWords();
  m_editor->redo();
  emit done(words.isEmpty() ? tr("Done again") : tr("Done again: %1").arg(words));
}

void UndoCommands::offerWhatCanBeDone() {
  // A scene may have an ampersand in its name, which menus take for a mark.
  const QString undoWords = m_editor->undoWords().replace('&', QStringLiteral("&&"));
  const QString redoWords = m_editor->redoWords().replace('&', QStringLiteral("&&"));
  m_undo->setEnabled(m_editor->canUndo());
  m_redo->setEnabled(m_editor->canRedo());
  m_undo->setText(undoWords.isEmpty() ? tr("&Undo") : tr("&Undo %1").arg(undoWords));
  m_redo->setText(redoWords.isEmpty() ? tr("&Redo") : tr("&Redo %1").arg(redoWords));
}

}  // namespace ui
