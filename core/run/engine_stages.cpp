#include "core/methods/taylor_series.h"
#include "core/run/engine.h"

namespace core {
namespace {

constexpr int kStatesPerPiece = 32;  // of an exact way, to draw it

Piece pieceOf(const StepPart& part) {
  Piece piece;
  piece.end = part.duration();
  piece.mode = part.mode;
  piece.beginState = part.beginState;
  return piece;
}

}  // namespace

std::vector<StepPart> Engine::latestStep(int index) const {
  if (m_moving.empty()) return {};
  const Moving& moving = m_moving[index];
  std::vector<const Piece*> pieces{&moving.piece};
  for (int i = moving.finished; i >= 0; i = m_finished[i].previous)
    pieces.insert(pieces.begin(), &m_finished[i].piece);
  const double start = static_cast<double>(m_before.stepCount) * m_solver.step;
  std::vector<StepPart> parts;
  for (const Piece* piece : pieces)
    if (piece->end > piece->begin)
      parts.push_back(opened(m_bodies[index], *piece, m_stepper, start));
  return parts;
}

StepPart Engine::retaken(int index, const StepPart& part, const Method& method) const {
  Stepper stepper(method, m_scene->gravity, m_scene->room.friction);
  Piece piece = pieceOf(part);
  stepper.fill(m_bodies[index], piece);
  return opened(m_bodies[index], piece, stepper, part.begin);
}

ExactWay Engine::exactWay(int index, const StepPart& part, double tolerance) const {
  Stepper stepper(TaylorSeries::kRow, m_scene->gravity, m_scene->room.friction);
  AdaptiveStepper adaptive(stepper, tolerance);
  ExactWay way{.times = {part.begin}, .states = {part.beginState}, .position = part.beginPosition};
  Pace pace;
  Piece piece = pieceOf(part);
  while (piece.begin < part.duration()) {
    piece.end = part.duration();
    if (!adaptive.fill(m_bodies[index], piece, pace)) break;
    for (int i = 1; i <= kStatesPerPiece; ++i) {
      const double s = piece.begin + (piece.end - piece.begin) * i / kStatesPerPiece;
      way.times.push_back(part.begin + s);
      way.states.push_back(piece.at(s));
    }
    piece.begin = piece.end;
    piece.beginState = piece.endState;
  }
  way.position = positionOf(m_bodies[index], part.mode, way.end());
  return way;
}

}  // namespace core
