#include "core/run/batch_stepper.h"

#include <utility>

#include "core/methods/method_list.h"
#include "core/motion/flight.h"
#include "core/motion/swing.h"
#include "core/run/path_end.h"

namespace core {
namespace {

template <class Block, class Slope>
[[gnu::always_inline]] inline void stepBlock(std::size_t method, Block& block, const Slope& slope) {
  withMethod(method, [&](auto unit) {
    using Unit = decltype(unit);
    block.beginSlope = slope(block.begin);
    block.end = Unit::step(slope, block.begin, block.beginSlope, block.duration).end;
    block.endSlope = pathEndSlope(Unit::kRow.path, slope, block.begin, block.end, block.beginSlope,
                                  block.duration);
  });
}

Entries wholeStateOf(const StateArray<5>& flight) {
  return flight;
}
Entries wholeStateOf(const StateArray<3>& swing) {
  return {swing[0], 0, swing[1], 0, swing[2]};
}

/// Of one weight, with the slope at the end of its path.
int evaluationsPerStep(const Method& method) {
  return method.slopesPerStep + (method.path == PathShape::kCubic ? 1 : 0);
}

/// Hands the results to the pieces and empties the block.
template <class Block>
void scatter(Block& block, PathShape path) {
  for (int lane = 0; lane < block.count; ++lane) {
    Piece& piece = *block.pieces[lane];
    piece.straight = path == PathShape::kStraight;
    piece.beginSlope = wholeStateOf(laneOf(block.beginSlope, lane));
    piece.endState = wholeStateOf(laneOf(block.end, lane));
    piece.endSlope = wholeStateOf(laneOf(block.endSlope, lane));
  }
  block.count = 0;
}

}  // namespace

BatchStepper::BatchStepper(const Method& method, double gravity)
    : m_method(&method),
      m_index(static_cast<std::size_t>(&method - methods().data())),
      m_gravity(gravity) {}

bool BatchStepper::takes(const Piece& piece) {
  return !piece.settled && (piece.mode == Mode::kFlight || piece.mode == Mode::kSwing);
}

template <int kEntries>
bool BatchStepper::Block<kEntries>::add(const Body& body, Piece& piece,
                                        const StateArray<kEntries>& state) {
  pieces[count] = &piece;
  duration = piece.end - piece.begin;
  mass.set(count, body.mass);
  length.set(count, body.length);
  drag.set(count, body.drag);
  setLane(begin, count, state);
  return ++count == Lanes::kCount;
}

void BatchStepper::add(const Body& body, Piece& piece) {
  const Entries& state = piece.beginState;
  if (piece.mode == Mode::kFlight) {
    if (m_flights.add(body, piece, state)) fillFlights();
  } else {
    if (m_swings.add(body, piece, {state[0], state[2], state[4]})) fillSwings();
  }
}

std::int64_t BatchStepper::finish() {
  if (m_flights.count > 0) fillFlights();
  if (m_swings.count > 0) fillSwings();
  return std::exchange(m_evaluations, 0);
}

CORE_VECTOR_SPEED
void BatchStepper::stepFlights(std::size_t method, double gravity, Block<5>& block) {
  stepBlock(method, block, Flight<Lanes>(gravity, block.mass, block.drag));
}

CORE_VECTOR_SPEED
void BatchStepper::stepSwings(std::size_t method, double gravity, Block<3>& block) {
  stepBlock(method, block, Swing<Lanes>(gravity, block.length, block.mass, block.drag));
}

void BatchStepper::fillFlights() {
  m_evaluations += m_flights.count * evaluationsPerStep(*m_method);
  stepFlights(m_index, m_gravity, m_flights);
  scatter(m_flights, m_method->path);
}

void BatchStepper::fillSwings() {
  m_evaluations += m_swings.count * evaluationsPerStep(*m_method);
  stepSwings(m_index, m_gravity, m_swings);
  scatter(m_swings, m_method->path);
}

}  // namespace core
