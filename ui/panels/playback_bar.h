#pragma once

#include <vector>

#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace ui {

class Commands;

/// Buttons for playing, the speed, and the simulated time in digits that can be read from
/// the back row. Where there is no room for words its buttons are icons alone.
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

  QSize minimumSizeHint() const override;

 signals:
  void speedChosen(double speed);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buttons(const Commands& commands);
  QWidget* speedBox();
  QWidget* timeBox();
  int widthWith(Qt::ToolButtonStyle style);
  void measure();
  void chooseStyle();

  QSlider* m_speedSlider;
  QLabel* m_speedLabel;
  QLabel* m_timeLabel;
  QLabel* m_paceLabel;
  std::vector<QToolButton*> m_wordButtons;
  int m_widthWithWords = 0;  // [px]
  int m_leastWidth = 0;      // without words [px]
  double m_speed = 1;
};

}  // namespace ui
