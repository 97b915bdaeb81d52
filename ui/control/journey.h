#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/run/event.h"
#include "ui/control/lanes.h"

namespace ui {

/// The way from the moment shown to another one, in pieces that fit frames.
///
/// What is recorded is restored: backwards always, forwards where a kept state makes the way
/// shorter. What is not is computed. A restoring that has been begun is finished before a new
/// goal is looked at, so that views follow a goal that moves on all the time.
class Journey {
 public:
  using EventFilter = std::function<bool(const core::Event&)>;
  /// Whether the present piece may take longer.
  using HasTime = std::function<bool()>;

  /// What a piece led to.
  struct Piece {
    double time = 0;               ///< that the lanes can show now [s]
    bool hasJumped = false;        ///< a moment of the record was restored
    bool hasFoundNothing = false;  ///< it is over, and there was no wanted event
  };

  bool isUnderWay() const { return m_goal.has_value(); }
  /// Where it leads [s]; nothing while its event is not found, or not under way.
  std::optional<double> goal() const { return m_wanted ? std::nullopt : m_goal; }
  /// Where it began [s].
  double start() const { return m_start; }
  /// Share of the way that is done, 0 to 1.
  /// @param time  shown [s]
  double progress(const Lanes& lanes, double time) const;

  /// Leads to `goal` [s] from now on; times before 0 mean 0.
  /// @param time  shown [s]
  void setGoal(double time, double goal);
  /// Leads to the first such event of that run after `time`, or to `atMost` [s].
  void setGoal(double time, double atMost, int run, EventFilter wanted);
  void end();

  /// Does a piece of the work, one step of a lane at least; ends when it is there.
  /// @param time  shown [s]
  /// @pre isUnderWay()
  Piece goOn(Lanes& lanes, double time, const HasTime& hasTime);

 private:
  bool restore(Lanes& lanes, Piece& piece, const HasTime& hasTime);
  void compute(Lanes& lanes, Piece& piece, const HasTime& hasTime);
  bool finds(const Lanes& lanes, const Lane& lane);

  double m_start = 0;             // [s]
  std::optional<double> m_goal;   // [s]
  std::optional<double> m_aim;    // of the lanes, while they are being restored [s]
  std::int64_t m_stepsAtAim = 0;  // to go when the lanes were aimed
  EventFilter m_wanted;           // ends the way earlier, in m_run
  int m_run = 0;
};

}  // namespace ui
