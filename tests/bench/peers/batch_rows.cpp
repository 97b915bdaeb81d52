#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/methods/method_list.h"
#include "core/motion/flight.h"
#include "core/motion/swing.h"
#include "core/run/batch_stepper.h"
#include "core/scene/scene.h"
#include "tests/bench/peers/batches.h"
#include "tests/bench/peers/rounds.h"
#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"

namespace bench {
namespace {

using core::Lanes;

/// The core's equations and method over a batch, without what a run keeps of every step.
template <int kEntries>
using Blocks = std::vector<core::StateArray<kEntries, Lanes>>;

CORE_VECTOR_SPEED
void stepFlights(Blocks<5>& blocks) {
  const core::Flight<Lanes> flight(kGravity, 1, kDrag);
  for (auto& block : blocks)
    block = core::RungeKutta4::step(flight, block, flight(block), kBatchStep).end;
}

CORE_VECTOR_SPEED
void stepSwings(Blocks<3>& blocks) {
  const core::Swing<Lanes> swing(kGravity, 1, 1, kDrag);
  for (auto& block : blocks)
    block = core::RungeKutta4::step(swing, block, swing(block), kBatchStep).end;
}

template <int kEntries>
std::shared_ptr<Blocks<kEntries>> blocksOf(int count) {
  constexpr int kStride = kEntries == 5 ? 1 : 2;
  auto blocks = std::make_shared<Blocks<kEntries>>((count + Lanes::kCount - 1) / Lanes::kCount);
  for (int i = 0; i < count; ++i) {
    core::StateArray<kEntries> state;
    for (int k = 0; k + 1 < kEntries; ++k) state[k] = startOf(i)[kStride * k];
    state[kEntries - 1] = 0;
    core::setLane((*blocks)[i / Lanes::kCount], i % Lanes::kCount, state);
  }
  return blocks;
}

BatchStep ourBlocks(int count, Motion motion) {
  if (motion == Motion::kFlight) {
    return [blocks = blocksOf<5>(count)] { stepFlights(*blocks); };
  }
  return [blocks = blocksOf<3>(count)] { stepSwings(*blocks); };
}

/// The same as a run takes its steps: out of every weight's record and into it, with the slopes
/// at both ends, which the search for events needs.
struct Pieces {
  core::BatchStepper stepper{*core::findMethod("rk4"), kGravity};
  std::vector<core::Body> bodies;
  std::vector<core::Piece> pieces;

  void step() {
    for (std::size_t i = 0; i < pieces.size(); ++i) stepper.add(bodies[i], pieces[i]);
    stepper.finish();
    for (core::Piece& piece : pieces) piece.beginState = piece.endState;
  }
};

BatchStep ourPieces(int count, Motion motion) {
  auto batch = std::make_shared<Pieces>();
  core::Piece piece;
  piece.end = kBatchStep;
  piece.mode = motion == Motion::kFlight ? core::Mode::kFlight : core::Mode::kSwing;
  for (int i = 0; i < count; ++i) {
    const auto start = startOf(i);
    batch->bodies.push_back({.mass = 1,
                             .radius = 0.02,
                             .drag = kDrag,
                             .hasRope = false,
                             .rigid = false,
                             .length = 1,
                             .pivot = {0, 0}});
    piece.beginState = core::flightEntries({start[0], start[1]}, {start[2], start[3]}, 0);
    batch->pieces.push_back(piece);
  }
  return [batch] { batch->step(); };
}

/// As many square roots as the steps of a batch of flights cannot do without.
CORE_VECTOR_SPEED
void takeRoots(std::vector<Lanes>& squares) {
  for (Lanes& square : squares)
    for (int k = 0; k < 4; ++k) square = sqrt(square);
}

BatchStep roots(int count) {
  auto squares = std::make_shared<std::vector<Lanes>>(count / Lanes::kCount, Lanes(2));
  return [squares] { takeRoots(*squares); };
}

struct BatchTimes {
  double blocks = 0, pieces = 0, odeint = 0;  // [s] per weight and step
  double ratio = 0, piecesRatio = 0;          // odeint / blocks, odeint / pieces
};

BatchTimes timedBatch(int count, Motion motion) {
  std::vector<Contender> contenders{{"blocks", ourBlocks(count, motion)},
                                    {"pieces", ourPieces(count, motion)}};
#ifdef BENCH_ODEINT
  contenders.push_back({"odeint", odeintBatch(count, motion)});
#endif
  const auto timings = timed(contenders);
  BatchTimes result{.blocks = timings[0].time / count, .pieces = timings[1].time / count};
  if (timings.size() > 2) {
    result.odeint = timings[2].time / count;
    result.ratio = timings[2].ratio;
    result.piecesRatio = timings[2].ratio / timings[1].ratio;
  }
  return result;
}

/// @param aim  least ratio; 0: stated
void printBatchRow(const std::string& work, double aim, double ours, double odeint, double ratio) {
  Row row{.work = work, .ours = duration(ours), .aim = aim > 0 ? text("≥ %g×", aim) : "stated"};
  if (odeint > 0) {
    row.peer = duration(odeint) + ", odeint, flat vector";
    row.ratio = times(ratio);
    row.isReached = ratio >= aim;
  }
  print(row);
}

void printFlightRows() {
  double fastest = INFINITY, slowest = 0;
  for (const auto& [count, aim] :
       {std::pair{100, 0.0}, {1000, 2.5}, {10'000, 0.0}, {100'000, 5.0}}) {
    const BatchTimes measured = timedBatch(count, Motion::kFlight);
    const std::string work = text("%d projectiles in air, Runge–Kutta 4: a weight's step", count);
    printBatchRow(work, aim, measured.blocks, measured.odeint, measured.ratio);
    printBatchRow("… out of a run's records and into them, with both ends' slopes", 0,
                  measured.pieces, measured.odeint, measured.piecesRatio);
    fastest = std::min(fastest, measured.blocks);
    slowest = std::max(slowest, measured.blocks);
  }
  print({.work = "… the slowest of these four counts over the fastest",
         .ours = times(slowest / fastest),
         .aim = "≤ 1.3×",
         .isReached = slowest <= 1.3 * fastest});
  constexpr int kRoots = 1000;
  const double limit = timed({{"roots", roots(kRoots)}})[0].time / kRoots;
  print({.work = "… over four square roots, which a step cannot do without",
         .ours = times(fastest / limit) + " of " + duration(limit),
         .aim = "stated"});
}

}  // namespace

void printBatchRows() {
  printFlightRows();
  constexpr int kPendulums = 1000;
  const BatchTimes measured = timedBatch(kPendulums, Motion::kSwing);
  const std::string work = "1000 pendulums, Runge–Kutta 4: a weight's step";
  printBatchRow(work, 3, measured.blocks, measured.odeint, measured.ratio);
  printBatchRow("… out of a run's records and into them, with both ends' slopes", 0,
                measured.pieces, measured.odeint, measured.piecesRatio);
}

}  // namespace bench
