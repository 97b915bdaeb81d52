#include "core/run/engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {
namespace {

// More events than this in one step, and the step is given up: it would never end.
constexpr std::int64_t kMostEventsPerStep = 500'000;

ContactTolerance toleranceFor(const Scene& scene) {
  // Places are rounded to about 10⁻¹⁶ of the room's size.
  const double rounding = 1e-15 * std::max(scene.room.width, scene.room.height);
  return {1e-12 + rounding, 1e-12 + rounding};
}

/// A graze shallower than this may be overlooked [m]: a thousandth of what an adaptive method
/// tolerates in a step, and little beside 1 µm: what is overlooked adds up over many.
double closenessFor(double tolerance) {
  return std::clamp(1e-3 * tolerance, 1e-10, 1e-7);
}

}  // namespace

Engine::Engine(std::shared_ptr<const Scene> scene, Solver solver)
    : m_scene(std::move(scene)),
      m_solver(std::move(solver)),
      m_bodies(bodiesOf(*m_scene)),
      m_stepper(*findMethod(m_solver.method), m_scene->gravity, m_scene->room.friction),
      m_batch(m_stepper.method(), m_scene->gravity),
      m_adaptiveStepper(m_stepper, m_solver.tolerance),
      m_tolerance(toleranceFor(*m_scene)),
      m_foresight(*m_scene, method().path, m_tolerance, closenessFor(m_solver.tolerance)) {
  m_now.weights.reserve(m_bodies.size());
  for (std::size_t i = 0; i < m_bodies.size(); ++i)
    m_now.weights.push_back(startRecord(m_scene->weights[i], m_bodies[i]));
  if (method().isAdaptive) m_now.paces.resize(m_bodies.size());
  const Energies start = energies();
  m_startEnergy = start.mechanical();
  if (m_scene->cutTime && *m_scene->cutTime <= 0) {
    m_now.cutTimePassed = true;
    cutNow(-1);
  }
}

WeightRecord Engine::startRecord(const Weight& weight, const Body& body) const {
  WeightRecord record;
  record.tied = body.hasRope;
  if (body.hasRope) {
    record.mode = Mode::kSwing;
    record.state << weight.rope->angle, 0, weight.rope->angularVelocity, 0, 0;
    if (body.rigid || m_foresight.tension(body, record.state) >= 0) return record;
  }
  record.mode = Mode::kFlight;
  const Eigen::Vector2d position = startPosition(weight);
  const Eigen::Vector2d velocity = startVelocity(weight);
  record.state = flightEntries(position, velocity, 0);
  const bool lies = position.y() - body.radius <= m_tolerance.gap && velocity.y() == 0;
  if (lies && m_scene->gravity > 0) record.mode = Mode::kSlide;
  return record;
}

RunStatus Engine::advance() {
  if (m_status != RunStatus::kRunning) return m_status;
  beginStep();
  placeAll();
  if (!stepAll()) {
    abandonStep(m_stalled ? RunStatus::kStalled : RunStatus::kDiverged);
    return m_status;
  }
  settle(0, false);
  if (!m_diverged) scheduleAll();
  if (m_diverged || m_isGivenUp || !processEvents()) {
    abandonStep(m_stalled    ? RunStatus::kStalled
                : m_diverged ? RunStatus::kDiverged
                             : RunStatus::kEndless);
    return m_status;
  }
  finishStep();
  return m_status;
}

bool Engine::tryAdvance(const Run::StepProgress& progress) {
  m_progress = progress ? &progress : nullptr;
  advance();
  m_progress = nullptr;
  return !std::exchange(m_isGivenUp, false);
}

bool Engine::mayGoOn(double s) {
  if (m_progress && !(*m_progress)(s / m_solver.step)) m_isGivenUp = true;
  return !m_isGivenUp;
}

void Engine::beginStep() {
  m_before = m_now.progress();
  if (m_progress) m_earlierEvents.swap(m_events);
  m_events = m_now.pending;
  m_now.pending.clear();
  m_eventMoments.assign(m_events.size(), 0);
  m_quietLosses.clear();
  m_finished.clear();
  m_queue.clear();
  m_ownSteps = 0;
  m_solvedAt = 0;
  m_diverged = false;
  m_stalled = false;
}

void Engine::placeAll() {
  m_moving.resize(m_bodies.size());
  m_localOf.assign(m_bodies.size(), -1);
  for (std::size_t i = 0; i < m_bodies.size(); ++i) {
    const WeightRecord& record = m_now.weights[i];
    m_moving[i] = {};
    m_moving[i].asleep = record.asleep;
    m_moving[i].stillFor = record.stillFor;
    Piece& piece = m_moving[i].piece;
    // A settled weight gets its piece when the forces in its group are known.
    piece.end = record.settled && !record.asleep ? 0 : m_solver.step;
    piece.mode = record.mode;
    piece.tied = record.tied;
    piece.settled = record.settled;
    piece.beginState = record.state;
  }
}

bool Engine::stepAll() {
  const bool together = !method().isAdaptive;
  if (together) fillTogether();
  m_boxes.resize(m_bodies.size());
  for (int i = 0; i < static_cast<int>(m_bodies.size()); ++i) {
    const Piece& piece = m_moving[i].piece;
    if (!mayGoOn(0)) return false;
    if (together ? !isFinite(i) : !fill(i)) return false;
    m_boxes[i] = boxOf(m_bodies[i], piece, piece.begin, piece.end);
  }
  m_broadPhase.rebuild();
  return true;
}

void Engine::scheduleAll() {
  const double start = time();
  if (m_scene->cutTime && !m_now.cutTimePassed &&
      *m_scene->cutTime <= static_cast<double>(m_now.stepCount + 1) * m_solver.step) {
    const double s = std::clamp(*m_scene->cutTime - start, 0.0, m_solver.step);
    m_queue.push({s, -1, -1, Upcoming::Kind::kCut, false, 0, 0});
  }
  for (double s = boundaryAfter(0); s < m_solver.step; s = boundaryAfter(s))
    m_queue.push({s, -1, -1, Upcoming::Kind::kSettle, false, 0, 0});
  for (int i = 0; i < static_cast<int>(m_bodies.size()) && mayGoOn(0); ++i) {
    scheduleOwn(i);
    m_broadPhase.forEachNear(m_boxes[i], [&](int other) {
      if (other > i) scheduleMeeting(i, other);
    });
  }
}

void Engine::schedule(int index) {
  scheduleOwn(index);
  m_broadPhase.forEachNear(m_boxes[index], [&](int other) {
    if (other != index) scheduleMeeting(std::min(index, other), std::max(index, other));
  });
}

void Engine::scheduleOwn(int index) {
  const Body& body = m_bodies[index];
  const Piece& piece = m_moving[index].piece;
  if (piece.settled) return;  // its contacts are its group's
  if (const auto moment = m_foresight.wall(body, piece, m_boxes[index]))
    push(moment->time, index, -1, moment->wall, moment->pressing);
  scheduleOwnStep(index);
  switch (piece.mode) {
    case Mode::kSwing:
      if (const auto moment = m_foresight.slack(body, piece))
        push(*moment, index, -1, Upcoming::Kind::kSlack);
      return scheduleTurningPoint(index, std::nullopt);
    case Mode::kSlide:
      if (const auto moment = m_foresight.stop(piece))
        push(*moment, index, -1, Upcoming::Kind::kStop);
      break;
    case Mode::kFlight:
      if (body.drag > 0 && method().mindsKinks())
        if (const auto moment = m_foresight.apex(piece))
          push(*moment, index, -1, Upcoming::Kind::kApex);
      break;
    case Mode::kHeld:
      return;
  }
  if (const auto moment = m_foresight.taut(body, piece))
    push(*moment, index, -1, Upcoming::Kind::kTaut);
}

void Engine::scheduleTurningPoint(int index, std::optional<double> before) {
  if (const auto moment = m_foresight.turningPoint(m_moving[index].piece, before))
    push(*moment, index, -1, Upcoming::Kind::kTurningPoint);
}

void Engine::scheduleMeeting(int a, int b) {
  if (!m_boxes[a].meets(m_boxes[b])) return;
  const Piece& pieceA = m_moving[a].piece;
  const Piece& pieceB = m_moving[b].piece;
  if (pieceA.settled && pieceB.settled) return;
  if (Stepper::isStill(pieceA) && Stepper::isStill(pieceB)) return;
  if (const auto moment = m_foresight.meeting(m_bodies[a], pieceA, m_bodies[b], pieceB))
    push(moment->time, a, b, Upcoming::Kind::kWeight, moment->pressing);
}

void Engine::push(double time, int weight, int other, Upcoming::Kind kind, bool pressing) {
  m_queue.push({time, weight, other, kind, pressing, m_moving[weight].stamp,
                other < 0 ? 0 : m_moving[other].stamp});
}

bool Engine::isCurrent(const Upcoming& event) const {
  if (event.weight < 0) return true;
  if (m_moving[event.weight].stamp != event.stamp) return false;
  return event.other < 0 || m_moving[event.other].stamp == event.otherStamp;
}

void Engine::dropStale() {
  while (!m_queue.isEmpty() && !isCurrent(m_queue.first())) m_queue.pop();
}

bool Engine::mustWait(const Upcoming& event, double s) {
  dropStale();
  if (m_queue.isEmpty() || m_queue.first().time >= s) return false;
  Upcoming later = event;
  later.time = s;
  later.polished = true;
  m_queue.push(later);
  return true;
}

bool Engine::processEvents() {
  std::int64_t count = 0;
  for (dropStale(); !m_queue.isEmpty(); dropStale()) {
    const Upcoming event = m_queue.pop();
    if (!mayGoOn(event.time)) return false;
    const bool isOwnStep = event.kind == Upcoming::Kind::kOwnStep;
    if (!isOwnStep && ++count > kMostEventsPerStep) return false;
    act(event);
    if (m_diverged) return false;
  }
  return true;
}

void Engine::finishStep() {
  for (std::size_t i = 0; i < m_bodies.size(); ++i) {
    const Piece& piece = m_moving[i].piece;
    m_now.losses.friction += slideLoss(static_cast<int>(i), piece, piece.end);
    m_now.weights[i] = {piece.endState, piece.mode,         piece.tied,
                        piece.settled,  m_moving[i].asleep, m_moving[i].stillFor};
  }
  m_now.evaluations = m_stepper.evaluations();
  ++m_now.stepCount;
}

void Engine::abandonStep(RunStatus status) {
  m_now.progress() = m_before;
  m_stepper.setEvaluations(m_now.evaluations);
  m_moving.clear();
  m_events.clear();
  m_quietLosses.clear();
  if (m_isGivenUp) return m_events.swap(m_earlierEvents);
  m_status = status;
}

bool Engine::isFinite(int index) const {
  const Piece& piece = m_moving[index].piece;
  // Squares of larger numbers are infinite: no place or energy can be told from them.
  constexpr double kLargest = 1e150;
  // Nor where a weight is that crosses the room within the last digit of a time in the step.
  const double fastest = 1e15 * std::max(m_scene->room.width, m_scene->room.height) / m_solver.step;
  // Nor what a rope does that turns so often that looking at every turn would take minutes.
  constexpr double kMostTurn = 2e4;
  if (turnWithin(piece, piece.begin, piece.end) > kMostTurn) return false;
  const double scale = isTethered(piece.mode) ? m_bodies[index].length : 1;
  return (piece.endState.abs() < kLargest).all() && (piece.endSlope.abs() < kLargest).all() &&
         (piece.beginSlope.abs() < kLargest).all() &&
         (scale * piece.endState.segment<2>(2).abs() < fastest).all();
}

double Engine::slideLoss(int index, const Piece& piece, double s) const {
  if (piece.mode != Mode::kSlide) return 0;
  const double force = m_bodies[index].mass * m_scene->room.friction * m_scene->gravity;
  return force * std::abs(piece.at(s)[0] - piece.beginState[0]);
}

void Engine::cutNow(int weight) {
  for (int i = 0; i < static_cast<int>(m_bodies.size()); ++i) {
    WeightRecord& record = m_now.weights[i];
    if (!record.tied || (weight >= 0 && weight != i)) continue;
    if (isTethered(record.mode)) {
      const Eigen::Vector2d position = positionOf(m_bodies[i], record.mode, record.state);
      const Eigen::Vector2d velocity = velocityOf(m_bodies[i], record.mode, record.state);
      record.state = flightEntries(position, velocity, record.state[4]);
      record.mode = Mode::kFlight;
    }
    record.tied = false;
    record.asleep = false;
  }
  Event event{.time = time(), .kind = EventKind::kCut, .weight = weight};
  if (weight >= 0) {
    const WeightState state = this->weight(weight);
    event.position = state.position;
    event.speedBefore = event.speedAfter = state.velocity.norm();
  }
  m_now.pending.push_back(event);
}

bool Engine::allCut() const {
  return std::ranges::none_of(m_now.weights, &WeightRecord::tied);
}

EngineState Engine::state() const {
  EngineState state = m_now;
  state.evaluations = m_stepper.evaluations();
  return state;
}

void Engine::restore(const EngineState& state) {
  m_now = state;
  m_before = state.progress();
  m_stepper.setEvaluations(state.evaluations);
  m_status = RunStatus::kRunning;
  m_moving.clear();
  m_finished.clear();
  m_events.clear();
  m_eventMoments.clear();
  m_quietLosses.clear();
}

}  // namespace core
