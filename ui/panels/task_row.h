#pragma once

#include <QWidget>

class QHBoxLayout;
class QProgressBar;
class QPushButton;

namespace ui {

class BackgroundTask;

/// A row of controls above a result: what its owner adds, a button that starts the work or
/// cancels it, and its progress.
class TaskRow : public QWidget {
  Q_OBJECT

 public:
  /// @param start  words on the button while nothing is done
  TaskRow(BackgroundTask* task, const QString& start, QWidget* parent = nullptr);

  /// Adds a control before the button, with its name before it unless that is empty.
  void add(const QString& name, QWidget* control);
  /// Adds a control at the end of the row.
  void addLast(QWidget* control);

 signals:
  /// The user wants the work to be done.
  void startWanted();

 private:
  void press();
  void showRunning(bool running);

  BackgroundTask* m_task;
  QString m_start;
  QHBoxLayout* m_layout;
  QPushButton* m_button;
  QProgressBar* m_progress;
};

}  // namespace ui
