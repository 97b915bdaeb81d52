#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/contact/broad_phase.h"
#include "core/contact/impulse.h"
#include "core/contact/resting.h"
#include "core/run/batch_stepper.h"
#include "core/run/engine_state.h"
#include "core/run/event_queue.h"
#include "core/run/foresight.h"
#include "core/run/run.h"
#include "core/run/stepper.h"

namespace core {

/// The work behind Run: one step at a time, events in time order.
///
/// In each step every weight is stepped to its end as if nothing happened. What the paths
/// foresee is queued; the earliest event is polished with the method itself, acted on, and
/// just the weights involved go on from there with new paths, until no event is left.
/// Times inside a step count from its start, so that they keep their digits late in a run.
class Engine {
 public:
  Engine(std::shared_ptr<const Scene> scene, Solver solver);
  Engine(const Engine&) = delete;  // parts know each other
  Engine& operator=(const Engine&) = delete;

  const Scene& scene() const { return *m_scene; }
  const std::shared_ptr<const Scene>& sharedScene() const { return m_scene; }
  const Solver& solver() const { return m_solver; }
  const Method& method() const { return m_stepper.method(); }
  std::int64_t stepCount() const { return m_now.stepCount; }
  double time() const { return static_cast<double>(m_now.stepCount) * m_solver.step; }
  RunStatus status() const { return m_status; }
  std::int64_t evaluations() const { return m_stepper.evaluations(); }
  double startEnergy() const { return m_startEnergy; }
  std::span<const Event> stepEvents() const { return m_events; }
  std::span<const Event> pendingEvents() const { return m_now.pending; }

  RunStatus advance();
  bool tryAdvance(const Run::StepProgress& progress);
  bool knowsLatestStep() const { return !m_moving.empty(); }
  void cutNow(int weight);  // −1: all
  bool allCut() const;

  WeightState weight(int index) const;
  WeightState weightAt(int index, double time) const;
  Energies energies() const;
  Energies energiesAt(double time) const;
  std::vector<StepPart> latestStep(int index) const;
  StepPart retaken(int index, const StepPart& part, const Method& method) const;
  ExactWay exactWay(int index, const StepPart& part, double tolerance) const;

  EngineState state() const;
  void restore(const EngineState& state);

 private:
  /// One weight within the present step.
  struct Moving {
    Piece piece;
    std::uint32_t stamp = 0;  // counts its pieces; foreseen events carry it
    int finished = -1;        // its latest finished piece of this step, or −1
    int meetings = 0;         // with other weights in this step
    bool asleep = false;
    double stillFor = 0;
    // What hits have changed its velocity by, each too little to tell its neighbours [m/s].
    Eigen::Vector2d untold{0, 0};
  };
  struct FinishedPiece {
    Piece piece;
    int previous;  // the same weight's one before, or −1
  };

  // Setting up.
  WeightRecord startRecord(const Weight& weight, const Body& body) const;

  // One step.
  void beginStep();
  void placeAll();
  bool stepAll();
  void scheduleAll();
  bool processEvents();
  void finishStep();
  void abandonStep(RunStatus status);
  /// Whether to go on with the step, which has come to s.
  bool mayGoOn(double s);
  bool isCurrent(const Upcoming& event) const;
  void dropStale();
  /// Puts an event back that polishing moved to s, if others come first now.
  bool mustWait(const Upcoming& event, double s);

  // Pieces (engine_pieces.cpp).
  void fillTogether();
  /// Gives the weight its way up to its piece's end, or as far as an adaptive method goes.
  /// @return  false, and m_diverged, where it cannot go on
  bool fill(int index);
  void beginOwnStep(const Upcoming& event);
  void scheduleOwnStep(int index);

  // Foreseeing.
  void schedule(int index);
  void scheduleOwn(int index);
  void scheduleTurningPoint(int index, std::optional<double> before);
  void scheduleMeeting(int a, int b);
  void push(double time, int weight, int other, Upcoming::Kind kind, bool pressing = false);

  // Acting on events.
  void act(const Upcoming& event);
  void cutAllAt(double s);
  void meet(const Upcoming& event);
  void exchange(const Upcoming& event, double s, const Entries& beforeA, const Entries& beforeB,
                const Eigen::Vector2d& normal);
  bool joinAtRest(const Upcoming& event, double approach, const Eigen::Vector2d& normal);
  bool meetsTooOften(int a, int b);
  void hitWall(const Upcoming& event);
  void hitWallInFlight(int index, double s, const Entries& before, const Upcoming& event);
  void hitWallOnRope(int index, double s, const Entries& before, const Upcoming& event);
  void rest(int index, double s, const Entries& before, const Entries& bounced, Mode mode,
            int rateEntry, double speed);
  void passTurningPoint(const Upcoming& event);
  void passApex(const Upcoming& event);
  void goSlack(const Upcoming& event);
  void goTaut(const Upcoming& event);
  double clearAngle(int index, double s, double angle, double reach);
  void stopSliding(const Upcoming& event);

  /// Ends the weight's piece at s in state `before` and starts another one from `after`.
  /// The first form leaves it to the caller to foresee what comes.
  void goOn(int index, double s, const Entries& before, Mode mode, const Entries& after, bool tied,
            bool settled);
  void goOn(int index, double s, const Entries& before, Mode mode, const Entries& after);

  /// Moves a foreseen event's moment to where `value` of the method's own partial step is zero.
  /// @param rate  d(value)/ds near there
  /// @return      nothing if the secant iteration does not settle: the path then decides
  template <class Value>
  std::optional<double> polished(const Upcoming& event, double low, double high, double rate,
                                 double tolerance, const Value& value);

  /// How large a gap that counts as closed may be [m].
  double polishTolerance() const { return m_tolerance.gap / 4; }
  /// Below that gap polishing ends [m]: the reference goes on to the last digit of places.
  double finestGap() const;

  // Groups in lasting contact (engine_resting.cpp, engine_spreading.cpp).
  class Group;
  struct QuietLoss {
    double moment;  // from the start of the step [s]
    Losses losses;
  };
  void settle(double s, bool foresee);
  std::vector<int> wakeTouching();
  double findForces(Group& group, double s);
  double pull(Group& group, double s);
  void warmStart(Group& group) const;
  void letGo(Group& group, double s);
  double endApproaches(Group& group) const;
  /// A hit between weights that lie is a lean below that speed [m/s]: between two solutions a
  /// weight of a group moves with what a whole stretch of gravity gave it.
  double slowestHit() const;
  void carryImpulses(const Group& group);
  void fallAsleep(const Group& group, double s);
  void goOnInGroup(const Group& group, double s, bool foresee);
  void hitGroup(int a, int b, double s, const Eigen::Vector2d& normal, double restitution,
                const std::vector<int>& landing);
  void soften(Group& group, const ContactGoal& goal, double duration, double restitution);
  void logHit(const Group& group, double s, double lost, const std::vector<int>& landing);
  class HitWave;
  void moveSpread(const Group& group, double s);
  bool isSupported(int index) const;
  Entries withVelocity(int index, Mode mode, const Entries& state,
                       const Eigen::Vector2d& velocity) const;
  void loseQuietly(double s, double impacts, double friction);
  double boundaryAfter(double s) const;
  /// When the stretch ends that begins there. An event may be placed before one that was dealt with
  /// earlier, by less than its method errs: a stretch that is over by then is not come back to.
  double stretchEnd(double s) const { return boundaryAfter(std::max(s, m_solvedAt)); }
  /// How much less exactly groups as large as the largest now are solved, ≥ 1.
  double looseness() const;
  /// How far weights that lean on each other are kept apart [m].
  double skin() const;
  int mostSweeps() const;

  // Weights in their states.
  const Piece& pieceAt(int index, double s) const;
  Eigen::Vector2d rateOf(int index, double s) const;
  CollidingWeight colliding(int index, Mode mode, const Entries& state) const;
  Entries pushed(int index, Mode mode, const Entries& state,
                 const Eigen::Vector2d& velocityChange) const;
  Entries freed(int index, Mode mode, const Entries& state) const;
  Mode modeAfterPush(Mode mode, const Entries& after, bool settled) const;
  bool isFinite(int index) const;
  bool comesToRest(double speedAfter, double inwardAcceleration, double radius) const;
  double slideLoss(int index, const Piece& piece, double s) const;

  WeightState readOut(int index, Mode mode, bool tied, const Entries& state) const;
  void log(EventKind kind, double s, int weight, const WeightState& before,
           const WeightState& after, double energyLost, int other = -1);

  std::shared_ptr<const Scene> m_scene;
  Solver m_solver;
  std::vector<Body> m_bodies;
  Stepper m_stepper;
  BatchStepper m_batch;
  AdaptiveStepper m_adaptiveStepper;
  ContactTolerance m_tolerance;
  Foresight m_foresight;
  double m_startEnergy = 0;

  RunStatus m_status = RunStatus::kRunning;
  EngineState m_now;  // at time(); its weights as they are until a step is finished
  Progress m_before;  // at the start of the latest step

  // The latest step.
  std::vector<Moving> m_moving;
  std::vector<FinishedPiece> m_finished;
  double m_fastestSettled = 0;  // since forces were found anew [m/s]
  double m_solvedAt = 0;        // when forces in groups were found anew [s]
  int m_settledCount = 0;       // awake, at that moment
  std::vector<int> m_localOf;   // of weights in the group being solved, or −1
  std::vector<Box> m_boxes;
  BroadPhase m_broadPhase{m_boxes};
  EventQueue m_queue;
  std::vector<Event> m_events;
  std::vector<Event> m_earlierEvents;  // of the step before one that may be given up
  std::vector<QuietLoss> m_quietLosses;
  std::vector<double> m_eventMoments;  // of m_events, from the start of the step [s]
  std::int64_t m_ownSteps = 0;         // of adaptive methods, all weights together
  bool m_diverged = false;
  bool m_stalled = false;
  const Run::StepProgress* m_progress = nullptr;  // null: nothing gives the step up
  bool m_isGivenUp = false;
};

template <class Value>
std::optional<double> Engine::polished(const Upcoming& event, double low, double high, double rate,
                                       double tolerance, const Value& value) {
  const double s = event.time;
  if (event.polished) return s;
  // A root much nearer to the start of the path is the one it sets out from.
  const double earliest = 0.5 * (low + s);
  const double wanted = std::min(tolerance, finestGap());
  double previous = s, previousValue = value(s);
  if (std::abs(previousValue) <= wanted) return s;
  std::optional<double> close;  // the latest guess within the tolerance, or the best if that is 0
  double closest = tolerance > 0 ? tolerance : std::abs(previousValue);
  if (std::abs(previousValue) <= tolerance) close = s;
  double guess = std::clamp(s - previousValue / rate, earliest, high);
  for (int i = 0; i < 10; ++i) {
    const double here = value(guess);
    if (std::abs(here) <= wanted) return guess;
    if (std::abs(here) <= closest) {
      close = guess;
      if (tolerance == 0) closest = std::abs(here);
    }
    const double next = guess - here * (guess - previous) / (here - previousValue);
    if (!(earliest <= next && next <= high)) return close;
    if (std::abs(next - guess) <= 1e-15 * high) return next;
    previous = guess;
    previousValue = here;
    guess = next;
  }
  return close;
}

}  // namespace core
