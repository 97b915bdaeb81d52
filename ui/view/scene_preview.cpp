#include "ui/view/scene_preview.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QFont>

#include "core/run/run.h"
#include "ui/view/camera.h"
#include "ui/view/qpainter_renderer.h"
#include "ui/view/room_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"
#include "ui/view/weight_drawing.h"

namespace ui {
namespace {

constexpr double kFrame = 1.0 / 60;  // between points of trails [s]
constexpr double kMargin = 10;       // around the room [px]
constexpr std::size_t kMany = 100;   // of more weights than these one run says enough

std::vector<core::Run> startedRuns(const core::Scene& scene) {
  const auto shared = std::make_shared<const core::Scene>(scene);
  std::vector<core::Run> runs;
  for (const core::Solver& solver : scene.solvers) {
    runs.emplace_back(shared, solver);
    if (scene.weights.size() > kMany) break;
  }
  return runs;
}

void advanceTo(double time, core::Run& run) {
  while (run.time() < time && run.advance() == core::RunStatus::kRunning) continue;
}

void readRun(const core::Run& run, double time, ShownRun& shown) {
  const double reached = std::min(time, run.time());
  for (std::size_t i = 0; i < shown.weights.size(); ++i)
    shown.weights[i] = run.weightAt(static_cast<int>(i), reached);
}

/// Lets the runs come to `time`, and notes the ways of their weights if they are few.
void play(std::vector<core::Run>& runs, double time, ShownScene& shown, Trails& trails) {
  const auto frames = static_cast<int>(std::lround(time / kFrame));
  const bool many = shown.scene.weights.size() > kMany;
  for (int frame = many ? frames : 0; frame <= frames; ++frame) {
    shown.time = frame * kFrame;
    for (std::size_t r = 0; r < runs.size(); ++r) {
      advanceTo(shown.time, runs[r]);
      readRun(runs[r], shown.time, shown.runs[r]);
    }
    trails.record(shown.time, shown.runs);
  }
}

Drawing drawingOf(const ShownScene& shown, const Trails& trails, const Camera& camera,
                  const SceneLook& look) {
  Drawing drawing;
  drawing.background = look.theme.background.rgb();
  drawRoom(shown.scene.room, roomRuler(shown.scene.room, camera, look), camera, look, drawing);
  drawTrails(shown, trails, look, drawing);
  drawRopes(shown, look, drawing);
  drawWeights(shown, camera, look, drawing);
  return drawing;
}

}  // namespace

QImage scenePreview(const core::Scene& scene, double time, QSize size, double devicePixelRatio,
                    const Theme& theme) {
  std::vector<core::Run> runs = startedRuns(scene);
  std::vector<const core::Run*> all;
  for (const core::Run& run : runs) all.push_back(&run);
  ShownScene shown = shownScene(all);
  Trails trails;
  trails.reset(static_cast<int>(runs.size()), static_cast<int>(scene.weights.size()),
               trailSpan(scene));
  play(runs, time, shown, trails);

  const SceneLook look{.theme = theme, .font = readableFont(QFont())};
  Camera camera;
  camera.setViewport(size, devicePixelRatio);
  camera.fit(QSizeF(scene.room.width, scene.room.height),
             QMarginsF(kMargin, kMargin, kMargin, kMargin));
  QImage image(size * devicePixelRatio, QImage::Format_RGB32);
  paintDrawing(drawingOf(shown, trails, camera, look), camera, image);
  image.setDevicePixelRatio(devicePixelRatio);  // only now: painting is in real pixels
  return image;
}

}  // namespace ui
