#pragma once

#include <QWidget>

class QLabel;

namespace ui {

/// The line above a presented scene: what to look for, if wanted, and the simulated time.
class PresentationHeader : public QWidget {
  Q_OBJECT

 public:
  explicit PresentationHeader(QWidget* parent = nullptr);

  /// The label for what to look for; hide it or show it.
  QLabel* sentence() const { return m_sentence; }

  /// @param time  simulated [s]
  void showTime(double time);

 private:
  QLabel* m_sentence;
  QLabel* m_time;
};

}  // namespace ui
