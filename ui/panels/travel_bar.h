#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;

namespace ui {

class RunController;

/// How far the way to a moment is done that takes long to get to, or a single step that playing
/// waits for, and a button to stop there. Hidden unless it takes more than an instant.
class TravelBar : public QWidget {
  Q_OBJECT

 public:
  explicit TravelBar(RunController* controller, QWidget* parent = nullptr);

 private:
  void showProgress();
  void showWaiting();
  void say(const QString& words, double progress);

  RunController* m_controller;
  QLabel* m_words;
  QProgressBar* m_progress;
  int m_told = 0;  // how often this way has been told about
};

}  // namespace ui
