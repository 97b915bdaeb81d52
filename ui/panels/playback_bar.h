#pragma once

#include <QWidget>

class QLabel;
class QSlider;

namespace ui {

class Commands;

/// Buttons for playing, the speed, and the simulated time in digits that can be read from
/// the back row.
class PlaybackBar : public QWidget {
  Q_OBJECT

 public:
  explicit PlaybackBar(const Commands& commands, QWidget* parent = nullptr);

  /// @param time  simulated [s]
  void showTime(double time);
  /// @param speed  one of 1/64, 1/32, …, 4
  void showSpeed(double speed);
  /// Tells by how much real time is missed.
  /// @param keptShare  of the wanted speed, 1 when it is kept
  void showKeptShare(double keptShare);

  /// The next slower or faster speed there is.
  double speedBeside(double speed, int steps) const;

 signals:
  void speedChosen(double speed);

 private:
  QWidget* buttons(const Commands& commands);
  QWidget* speedBox();
  QWidget* timeBox();

  QSlider* m_speedSlider;
  QLabel* m_speedLabel;
  QLabel* m_timeLabel;
  QLabel* m_paceLabel;
  double m_speed = 1;
};

}  // namespace ui
