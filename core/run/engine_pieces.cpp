#include "core/run/engine.h"

// How weights get their pieces. A method with a fixed step fills each up to the end of the
// step; an adaptive one ends it where its tolerance does, and an event of the weight's own
// begins the next.

namespace core {
namespace {

// An adaptive method that takes more steps than this within one of the run's, for all weights
// together and on top for each, is given up: it would take minutes.
constexpr std::int64_t kMostOwnSteps = 1'000'000;
constexpr std::int64_t kMostOwnStepsPerWeight = 1'000;

}  // namespace

bool Engine::fill(int index) {
  Piece& piece = m_moving[index].piece;
  if (!method().isAdaptive) {
    m_stepper.fill(m_bodies[index], piece);
  } else {
    m_stalled = !m_adaptiveStepper.fill(m_bodies[index], piece, m_now.paces[index]);
  }
  m_diverged = m_stalled || !isFinite(index);
  return !m_diverged;
}

void Engine::fillTogether() {
  for (std::size_t i = 0; i < m_bodies.size(); ++i) {
    Piece& piece = m_moving[i].piece;
    if (BatchStepper::takes(piece)) {
      m_batch.add(m_bodies[i], piece);
    } else {
      m_stepper.fill(m_bodies[i], piece);
    }
  }
  m_stepper.addEvaluations(m_batch.finish());
}

void Engine::scheduleOwnStep(int index) {
  const Piece& piece = m_moving[index].piece;
  if (piece.end < m_solver.step) push(piece.end, index, -1, Upcoming::Kind::kOwnStep);
}

void Engine::beginOwnStep(const Upcoming& event) {
  const auto count = static_cast<std::int64_t>(m_bodies.size());
  if (++m_ownSteps > kMostOwnSteps + count * kMostOwnStepsPerWeight) {
    m_diverged = m_stalled = true;
    return;
  }
  const Piece piece = m_moving[event.weight].piece;
  goOn(event.weight, piece.end, piece.endState, piece.mode, piece.endState);
}

double Engine::finestGap() const {
  if (method().path != PathShape::kPolynomial) return polishTolerance();
  return 4e-16 * std::max(m_scene->room.width, m_scene->room.height);
}

}  // namespace core
