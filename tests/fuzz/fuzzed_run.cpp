#include "tests/fuzz/fuzzed_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/methods/method.h"
#include "core/run/run.h"
#include "core/run/run_state.h"
#include "core/scene/scene_limits.h"
#include "tests/fuzz/choices.h"
#include "tests/support/fingerprint.h"
#include "tests/support/processor_time.h"
#include "tests/support/run_watch.h"

namespace tests {
namespace {

using core::Range;
using core::Run;
using core::RunStatus;
using Eigen::Vector2d;

constexpr double kDuration = 2;  // [s]
// At which no method makes the numbers of an ordinary scene grow beyond all bounds [s].
constexpr double kFineStep = 1.0 / 240;
// That is usual [s].
constexpr double kPlayedStep = 1.0 / 60;
// Closer to 1 hops in their tens of thousands are what such a scene does.
constexpr double kNearlyElastic = 0.999;
// Questions whether to go on, one or more for each event: seconds of work, and 100 MiB of events.
constexpr int kMostQuestions = 20'000;
constexpr int kMostQuestionsInOrdinary = 100'000;
// A rope that turns 3000 times in a step makes a long answer of each [s of the processor's time].
constexpr double kMostTime = 15;

/// What numbers are chosen from.
struct Ranges {
  Range gravity, airDensity, roomSize, friction, mass, radius, dragCoefficient, ropeLength, turning,
      speed;
};

constexpr Ranges kOrdinary{.gravity = {0, 30, ""},
                           .airDensity = {0, 2, ""},
                           .roomSize = {0.5, 4, ""},
                           .friction = {0, 1, ""},
                           .mass = {0.003, 3, ""},
                           .radius = {0.005, 0.1, ""},
                           .dragCoefficient = {0, 1, ""},
                           .ropeLength = {0.1, 2, ""},
                           .turning = {-6, 6, ""},
                           .speed = {-8, 8, ""}};

constexpr double kFastestTurn = core::kAngularVelocityRange.highest / 180 * std::numbers::pi;
constexpr Ranges kExtreme{.gravity = core::kGravityRange,
                          .airDensity = core::kAirDensityRange,
                          .roomSize = core::kRoomSizeRange,
                          .friction = core::kFrictionRange,
                          .mass = core::kMassRange,
                          .radius = core::kRadiusRange,
                          .dragCoefficient = core::kDragCoefficientRange,
                          .ropeLength = core::kRopeLengthRange,
                          .turning = {-kFastestTurn, kFastestTurn, ""},
                          .speed = core::kVelocityRange};

/// Makes a scene of choices, weight by weight.
class SceneMaker {
 public:
  SceneMaker(Choices& choices, const Ranges& ranges) : m_choices(choices), m_ranges(ranges) {}

  core::Scene scene() {
    m_scene.gravity = number(m_ranges.gravity);
    m_scene.airDensity = number(m_ranges.airDensity);
    m_scene.room = {.width = number(m_ranges.roomSize),
                    .height = number(m_ranges.roomSize),
                    .restitution = number(core::kRestitutionRange),
                    .friction = number(m_ranges.friction)};
    m_scene.restitution = number(core::kRestitutionRange);
    if (m_choices.bit()) m_scene.cutTime = m_choices.number(0, kDuration);
    // What does not fit in is left out.
    for (int i = 0; i < kMostFuzzedWeights && !m_choices.isUsedUp(); ++i) {
      m_scene.weights.push_back(weight());
      if (!core::problemsIn(m_scene).empty()) m_scene.weights.pop_back();
    }
    return m_scene;
  }

 private:
  double number(const Range& range) { return m_choices.number(range.lowest, range.highest); }
  Vector2d vector(const Range& range) {
    const double x = number(range);
    return {x, number(range)};
  }

  core::Weight weight() {
    // As the one before, or of its own kind.
    core::Weight weight = m_scene.weights.empty() ? core::Weight() : m_scene.weights.back();
    weight.rope.reset();
    if (m_scene.weights.empty() || m_choices.bit()) {
      const double room = std::min(m_scene.room.width, m_scene.room.height);
      weight.mass = number(m_ranges.mass);
      weight.radius =
          m_choices.number(m_ranges.radius.lowest,
                           std::clamp(room / 4, m_ranges.radius.lowest, m_ranges.radius.highest));
      weight.dragCoefficient = number(m_ranges.dragCoefficient);
    }
    if (m_choices.bit()) {
      weight.rope = rope();
    } else {
      weight.position = place(weight.radius);
      weight.velocity = m_choices.bit() ? vector(m_ranges.speed) : Vector2d(0, 0);
    }
    return weight;
  }

  core::Rope rope() {
    core::Rope rope;
    rope.length = number(m_ranges.ropeLength);
    rope.pivot = placeInRoom(0);
    rope.angle = m_choices.number(-std::numbers::pi, std::numbers::pi);
    if (m_choices.bit()) rope.angularVelocity = number(m_ranges.turning);
    rope.rigid = m_choices.bit();
    return rope;
  }

  Vector2d placeInRoom(double margin) {
    const double x = m_choices.number(margin, std::max(margin, m_scene.room.width - margin));
    return {x, m_choices.number(margin, std::max(margin, m_scene.room.height - margin))};
  }

  /// Anywhere, on the floor, or touching the weight before.
  Vector2d place(double radius) {
    const int way = m_choices.oneOf(4);
    if (way == 1) return {placeInRoom(radius).x(), radius};
    if (way == 2 && !m_scene.weights.empty()) {
      const core::Weight& other = m_scene.weights.back();
      const double direction = m_choices.oneOf(24) * std::numbers::pi / 12;
      const double distance = other.radius + radius;
      return core::startPosition(other) +
             distance * Vector2d(std::cos(direction), std::sin(direction));
    }
    return placeInRoom(radius);
  }

  Choices& m_choices;
  const Ranges& m_ranges;
  core::Scene m_scene;
};

core::Solver fuzzedSolver(Choices& choices, bool isOrdinary) {
  constexpr std::array kSteps{1.0 / 60, 1.0 / 240, 1e-6, 1e-3, 0.1, 1.0};
  const std::span<const core::Method> methods = core::methods();
  // One more than are offered: the reference.
  const int method = choices.oneOf(static_cast<int>(methods.size()) + 1);
  core::Solver solver;
  solver.method = method < static_cast<int>(methods.size()) ? methods[method].id : "reference";
  const int step = choices.oneOf(2 * static_cast<int>(kSteps.size()));
  solver.step = step < static_cast<int>(kSteps.size()) ? kSteps[step] : choices.number(1e-6, 1);
  solver.tolerance = choices.number(isOrdinary ? 1e-12 : core::kToleranceRange.lowest,
                                    isOrdinary ? 1e-3 : core::kToleranceRange.highest);
  if (solver.method == "reference") solver.tolerance = 1e-14;
  return solver;
}

int fuzzedStep(Choices& choices, int steps) {
  return choices.bit() ? choices.oneOf(256) * steps / 256 : -1;
}

int stepsOf(const core::Solver& solver) {
  return static_cast<int>(
      std::min<double>(kMostFuzzedSteps, std::max(1.0, std::ceil(kDuration / solver.step))));
}

/// The same hand on a run and on the one that goes on from its state.
void cutByHand(Run& run, const FuzzedRun& fuzzed) {
  if (run.stepCount() == fuzzed.cutAllBefore) run.cutAll();
  if (run.stepCount() == fuzzed.cutOneBefore && run.weightCount() > 0) run.cut(0);
}

/// Steps until there is more work than anybody waits for.
class PatientRun {
 public:
  explicit PatientRun(const FuzzedRun& fuzzed)
      : m_fuzzed(fuzzed), run(fuzzed.scene, fuzzed.solver) {}

  /// @return  false where the run ended, or was given up
  bool advance() {
    cutByHand(run, m_fuzzed);
    const bool isTaken = run.tryAdvance([&](double) { return goesOn(); });
    return isTaken && run.status() == RunStatus::kRunning;
  }
  bool isGivenUp() const { return m_isGivenUp; }

 private:
  bool goesOn() {
    const int most = m_fuzzed.isOrdinary ? kMostQuestionsInOrdinary : kMostQuestions;
    const bool isLate = !m_fuzzed.isOrdinary && processorTime() - m_start > kMostTime;
    m_isGivenUp = ++m_questions >= most || isLate;
    return !m_isGivenUp;
  }

  const FuzzedRun& m_fuzzed;
  int m_questions = 0;
  double m_start = processorTime();  // [s]
  bool m_isGivenUp = false;

 public:
  Run run;
};

/// Whether it cannot have more work than a patient run does. A long step may blow up in dense air,
/// or hold any number of bounces.
bool mustEndSoon(const FuzzedRun& fuzzed) {
  const core::Scene& scene = *fuzzed.scene;
  const bool isElastic = std::max(scene.room.restitution, scene.restitution) > kNearlyElastic;
  return fuzzed.isOrdinary && fuzzed.solver.step <= kPlayedStep && !isElastic;
}

std::string faultInResumed(const FuzzedRun& fuzzed, const core::RunState& state, const Run& run) {
  PatientRun resumed(fuzzed);
  resumed.run.restore(state);
  while (resumed.run.stepCount() < run.stepCount() && resumed.advance()) {
  }
  if (resumed.isGivenUp()) return {};
  return fingerprint(resumed.run) == fingerprint(run) ? "" : "another way from a state of its own";
}

}  // namespace

FuzzedRun fuzzedRun(std::span<const std::uint8_t> bytes) {
  Choices choices(bytes);
  FuzzedRun fuzzed;
  fuzzed.isOrdinary = choices.bit();
  fuzzed.solver = fuzzedSolver(choices, fuzzed.isOrdinary);
  const int steps = stepsOf(fuzzed.solver);
  fuzzed.cutAllBefore = fuzzedStep(choices, steps);
  fuzzed.cutOneBefore = fuzzedStep(choices, steps);
  fuzzed.resumedAt = fuzzedStep(choices, steps);
  const Ranges& ranges = fuzzed.isOrdinary ? kOrdinary : kExtreme;
  fuzzed.scene = std::make_shared<const core::Scene>(SceneMaker(choices, ranges).scene());
  return fuzzed;
}

std::string faultIn(const FuzzedRun& fuzzed) {
  PatientRun patient(fuzzed);
  const Run& run = patient.run;
  Bounds bounds = fuzzed.isOrdinary ? Bounds::ordinary() : Bounds::extreme(fuzzed.scene->room);
  // The path of a long step on a rope is as coarse as the step.
  bounds.looksInside = bounds.looksInside && fuzzed.solver.step <= kPlayedStep;
  RunWatch watch(run, bounds);
  std::optional<core::RunState> state;
  for (int step = 0; step < stepsOf(fuzzed.solver); ++step) {
    if (step == fuzzed.resumedAt) state = run.state();
    if (!patient.advance()) break;
    std::string fault = watch.faultAfterStep(run);
    if (!fault.empty()) return fault;
  }
  if (!isFinite(run)) return "numbers that are not finite at the end";
  if (patient.isGivenUp()) return mustEndSoon(fuzzed) ? "more work than such a scene can have" : "";
  const bool isFine = run.method().isAdaptive || run.solver().step <= kFineStep;
  if (fuzzed.isOrdinary && isFine && run.status() != RunStatus::kRunning)
    return "an end in the middle of an ordinary scene";
  if (state && run.status() == RunStatus::kRunning) return faultInResumed(fuzzed, *state, run);
  return {};
}

}  // namespace tests
