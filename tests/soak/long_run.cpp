#include "tests/soak/long_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/recording/recording.h"
#include "core/run/run.h"
#include "ui/files/scene_file.h"

namespace {

double deepestOverlap(const core::Run& run) {
  const std::vector<core::Weight>& weights = run.scene().weights;
  double deepest = 0;
  for (int i = 0; i < run.weightCount(); ++i) {
    const Eigen::Vector2d place = run.weightAt(i, run.time()).position;
    for (int j = 0; j < i; ++j) {
      const double distance = (place - run.weightAt(j, run.time()).position).norm();
      deepest = std::max(deepest, weights[i].radius + weights[j].radius - distance);
    }
  }
  return deepest;
}

LongRunFigures figuresOf(const core::Run& run, double startEnergy, std::int64_t events) {
  return {.time = run.time(),
          .drift = run.energiesAt(run.time()).numericalDrift / startEnergy,
          .overlap = deepestOverlap(run),
          .events = events,
          .process = figuresNow()};
}

}  // namespace

void runLong(const std::shared_ptr<const core::Scene>& scene, double until, double every,
             bool isRecorded, const std::function<void(const LongRunFigures&)>& report) {
  core::Run run(scene, {.method = "rk4", .step = 1.0 / 60});
  core::Recording recording;
  if (isRecorded) recording.start(run);
  const double startEnergy = run.energiesAt(0).accounted();
  std::int64_t events = 0;
  int reports = 0;
  do {
    if (run.time() >= every * reports) {
      report(figuresOf(run, startEnergy, events));
      ++reports;
    }
    if (run.advance() != core::RunStatus::kRunning) return;
    events += static_cast<std::int64_t>(run.stepEvents().size());
    if (isRecorded) recording.record(run);
  } while (run.time() < until);
  report(figuresOf(run, startEnergy, events));
}

std::shared_ptr<const core::Scene> sevenThatNeverRest() {
  core::Scene scene = ui::builtInScene(QStringLiteral("seven-weights"));
  scene.airDensity = 0;
  scene.restitution = 1;
  scene.room.restitution = 1;
  scene.room.friction = 0;
  return std::make_shared<const core::Scene>(std::move(scene));
}

std::shared_ptr<const core::Scene> pileThatRests() {
  return std::make_shared<const core::Scene>(ui::builtInScene(QStringLiteral("pile")));
}
