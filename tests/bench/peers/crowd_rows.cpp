#include <algorithm>
#include <cmath>
#include <malloc.h>
#include <memory>
#include <vector>

#include "tests/bench/peers/discs.h"
#include "tests/bench/peers/rounds.h"
#include "tests/bench/peers/rows.h"
#include "tests/bench/peers/table.h"
#include "tests/support/crowd.h"
#include "tests/support/processor_time.h"

namespace bench {
namespace {

core::Scene crowdWithoutAir(int count) {
  core::Scene scene = tests::crowd(count);
  scene.airDensity = 0;
  return scene;
}

/// Memory this program has asked for and not given back [bytes].
double memoryHeld() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Of a world after some steps, with what it keeps of the scene it was made from [bytes].
double memoryOf(const Engine& engine, int count) {
  const core::Scene scene = crowdWithoutAir(count);
  const double before = memoryHeld();
  const auto world = engine.make(scene, engine.options);
  for (int i = 0; i < 10; ++i) world->step();
  return memoryHeld() - before;
}

struct CrowdFigures {
  double time = 0;     // of computing per step, median of rounds [s]
  double ratio = 0;    // median of the rounds, to ours
  double overlap = 0;  // largest after any step [m]
  double kinetic = 0;  // at the end [J]
};

// An engine that has taken so many times as long as we do for all steps is stopped: Box2D goes
// through all contacts again for each one it locates, which takes hours for 10,000 discs.
constexpr double kPatience = 2;

/// Steps every engine's world in turn, round by round. Overlaps are looked for in the first
/// round, between steps whose time counts. The time of an engine that was stopped is infinite.
std::vector<CrowdFigures> figuresOf(const std::vector<Engine>& engines, const core::Scene& scene,
                                    int steps, int rounds) {
  std::vector<CrowdFigures> figures(engines.size());
  std::vector<std::vector<double>> times(engines.size()), ratios(engines.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < engines.size(); ++i) {
      const auto world = engines[i].make(scene, engines[i].options);
      double time = 0;
      for (int step = 0; step < steps; ++step) {
        const double start = tests::processorTime();
        world->step();
        time += tests::processorTime() - start;
        if (i > 0 && time > kPatience * times[0].back() * steps) {
          time = INFINITY;
          break;
        }
        if (round == 0)
          figures[i].overlap = std::max(figures[i].overlap, largestOverlap(scene, *world));
      }
      figures[i].kinetic = kineticEnergy(scene, *world);
      times[i].push_back(time / steps);
      ratios[i].push_back(times[i].back() / times[0].back());
    }
  for (std::size_t i = 0; i < engines.size(); ++i) {
    figures[i].time = median(times[i]);
    figures[i].ratio = median(ratios[i]);
  }
  return figures;
}

/// Where the fastest of the others stands; 0 if there are none.
std::size_t fastestPeer(const std::vector<CrowdFigures>& figures) {
  std::size_t best = figures.size() > 1 ? 1 : 0;
  for (std::size_t i = 1; i < figures.size(); ++i)
    if (figures[i].time < figures[best].time) best = i;
  return best;
}

std::string timeAndOverlap(const CrowdFigures& figures) {
  return duration(figures.time) + text("; %.1e m", figures.overlap);
}

void printCrowdRow(int count, int seconds) {
  const std::vector<Engine> engines = crowdEngines();
  const int rounds = count <= 100 && seconds == 1 ? 7 : (count <= 1000 && seconds == 1 ? 3 : 1);
  const auto figures = figuresOf(engines, crowdWithoutAir(count), 60 * seconds, rounds);
  Row row{.work = text("%d discs poured, packing 0.3, e = 0.8, %d s: a step of 1/60 s; overlap",
                       count, seconds),
          .ours = timeAndOverlap(figures[0]),
          .aim = "≥ 1×, ≤ 1e-5 m"};
  if (const std::size_t best = fastestPeer(figures)) {
    row.peer = timeAndOverlap(figures[best]) + ", " + engines[best].name;
    row.ratio = times(figures[best].ratio);
    row.isReached = figures[best].ratio >= 1 && figures[0].overlap <= 1e-5;
  }
  print(row);
}

void printElasticRow() {
  core::Scene scene = crowdWithoutAir(100);
  scene.gravity = 0;
  scene.restitution = scene.room.restitution = 1;
  double start = 0;
  for (const core::Weight& weight : scene.weights)
    start += weight.mass * weight.velocity.squaredNorm() / 2;
  std::vector<Engine> engines = crowdEngines();
  for (Engine& engine : engines) engine.options.mayRest = false;
  const auto figures = figuresOf(engines, scene, 600, 1);
  std::vector<double> errors;
  for (const CrowdFigures& each : figures) errors.push_back(std::abs(each.kinetic / start - 1));
  Row row{.work = "100 discs, elastic, no gravity, 10 s: energy error; a step of 1/60 s",
          .ours = text("%.1e; ", errors[0]) + duration(figures[0].time),
          .aim = "≤ 1e-10"};
  row.isReached = errors[0] <= 1e-10;
  if (engines.size() > 1) {
    const auto best = std::min_element(errors.begin() + 1, errors.end()) - errors.begin();
    row.peer =
        text("%.1e; ", errors[best]) + duration(figures[best].time) + ", " + engines[best].name;
    row.ratio = times(errors[best] / errors[0]);
  }
  print(row);
}

std::string heapText(const CrowdFigures& figures) {
  return timeAndOverlap(figures) + text("; %.1e J", figures.kinetic);
}

}  // namespace

void printMemoryRows() {
  for (const auto& [count, most] : {std::pair{1000, 1.0}, {10000, 5.0}}) {
    constexpr double kMebibyte = 1 << 20;
    const auto above = [count = count](const Engine& engine) {
      return (memoryOf(engine, count) - memoryOf(engine, 0)) / kMebibyte;
    };
    const double ours = above({"Angry Cuts", ourWorld});
    Row row{.work = text("memory of %d weights, no history", count),
            .ours = text("%.2g MiB", ours),
            .aim = text("≤ %g MiB", most)};
    row.isReached = ours <= most;
    double least = INFINITY;
    for (const Engine& engine : otherEngines()) {
      const double peer = above(engine);
      if (peer >= least) continue;
      least = peer;
      row.peer = text("%.2g MiB, ", peer) + engine.name;
      row.ratio = times(peer / ours);
    }
    print(row);
  }
}

void printCrowdRows(bool isThorough) {
  for (const int count : {10, 100, 1000}) printCrowdRow(count, 1);
  if (isThorough) {
    for (const int count : {10, 100, 1000}) printCrowdRow(count, 10);
    for (const int seconds : {1, 10}) printCrowdRow(10000, seconds);
  }
  printElasticRow();
}

void printHeapRows() {
  const std::vector<Engine> engines = crowdEngines();
  const auto figures = figuresOf(engines, crowdWithoutAir(50), 60 * 60, 1);
  Row row{.work = "50 discs settle for 60 s: a step of 1/60 s; overlap; kinetic energy left",
          .ours = heapText(figures[0]),
          .aim = "all at most theirs"};
  if (const std::size_t best = fastestPeer(figures)) {
    row.peer = heapText(figures[best]) + ", " + engines[best].name;
    row.ratio = times(figures[best].ratio);
    row.isReached = std::all_of(figures.begin() + 1, figures.end(), [&](const auto& peer) {
      return figures[0].time <= peer.time && figures[0].overlap <= peer.overlap &&
             figures[0].kinetic <= peer.kinetic;
    });
  }
  print(row);
}

}  // namespace bench
