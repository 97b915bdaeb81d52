#pragma once

namespace core {

/// Turns uneven frame times into simulated time, so that a run never depends on how fast
/// the screen draws.
///
/// The shown time moves with the wall clock times the speed. Each run is advanced by whole
/// steps until it has reached the shown time. A machine too slow for that reports how far
/// it came, and the surplus is dropped: the show falls behind the wall clock instead of
/// freezing the window.
class StepClock {
 public:
  /// @param longestFrame  most wall time one frame may stand for [s], > 0; a paused laptop
  ///                      or a dragged window then costs one such frame, not a jump
  explicit StepClock(double longestFrame = 0.1);

  /// Simulated seconds per second of the wall clock, > 0.
  void setSpeed(double speed);
  double speed() const { return m_speed; }

  /// Starts again at `time` [s].
  void reset(double time);

  /// Simulated time to show after `elapsed` more seconds of the wall clock [s].
  /// @param elapsed  [s], ≥ 0
  double targetAfter(double elapsed);

  /// Tells how far the runs really came [s], at most the target.
  void reached(double time);
  /// The same where a step still takes: the rest of the frame goes on, and counts with the next.
  void wait(double time);
  /// How long the frame has been going on for that reason [s].
  double waited() const { return m_waited; }

  /// Time shown now [s].
  double time() const { return m_time; }

  /// How much of the wanted speed is kept: 1 in real time, 0.25 when four times too slow.
  /// A mean over about the last second of wall time.
  double keptShare() const;

 private:
  double m_longestFrame;
  double m_speed = 1;
  double m_time = 0;
  double m_target = 0;   // of the present frame; m_time between frames
  double m_elapsed = 0;  // wall time of the present frame [s]; 0 between frames
  double m_waited = 0;   // the part of it that wait() put off [s]
  double m_keptShare = 1;
};

}  // namespace core
