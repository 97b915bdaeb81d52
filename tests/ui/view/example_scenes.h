#pragma once

#include <numbers>

#include <QCoreApplication>

#include "ui/view/camera.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

namespace example {

/// So many free weights on a line across a 4 m × 3 m room, in two runs; those of the second
/// stand `apart` [m] beside those of the first.
inline ui::ShownScene freeWeights(int count, double radius, double apart) {
  ui::ShownScene shown;
  shown.runs = {{"first method", 0, {}}, {"second method", 1, {}}};
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    weight.radius = radius;
    weight.position = {4.0 * (i + 1) / (count + 1), 1};
    shown.scene.weights.push_back(weight);
    shown.colors.push_back(qRgb(230, 159, 0));
    core::WeightState state;
    state.position = weight.position;
    shown.runs[0].weights.push_back(state);
    state.position.x() += apart;
    shown.runs[1].weights.push_back(state);
  }
  return shown;
}

/// One weight on a rope of 1 m, tied at (2, 2.5), hanging straight down, in one run.
inline ui::ShownScene hangingWeight(core::Phase phase, bool rigid = false) {
  ui::ShownScene shown = freeWeights(1, 0.02, 0);
  shown.runs.pop_back();
  shown.scene.weights[0].rope = core::Rope{{2, 2.5}, 1, 0, 0, rigid};
  shown.runs[0].weights[0].position = {2, 1.5};
  shown.runs[0].weights[0].phase = phase;
  return shown;
}

/// A bit of everything: big and small weights on ropes and free, two runs apart, trails.
inline ui::ShownScene everything(ui::Trails& trails) {
  ui::ShownScene shown = freeWeights(7, 0.05, 0.12);
  for (int i = 0; i < 3; ++i) {
    shown.scene.weights[i].rope = core::Rope{{0.6 + 0.5 * i, 2.7}, 1.8, 0, 0, /*rigid=*/i == 1};
    for (ui::ShownRun& run : shown.runs)
      run.weights[i].phase = i == 2 ? core::Phase::kSlack : core::Phase::kTethered;
  }
  shown.scene.weights[6].radius = 0.3;
  shown.target = {{3, 0.4}, {ui::ShownLanding{3.05, 1}, std::nullopt}};
  shown.colors = {0xffe69f00, 0xff56b4e9, 0xff009e73, 0xfff0e442,
                  0xff0072b2, 0xffd55e00, 0xff000000};
  trails.reset(2, 7, 2);
  std::vector<ui::ShownRun> past = shown.runs;
  for (int step = 60; step >= 0; --step) {
    const double back = step / 60.0;
    for (std::size_t r = 0; r < past.size(); ++r)
      for (std::size_t i = 0; i < 7; ++i)
        past[r].weights[i].position =
            shown.runs[r].weights[i].position + Eigen::Vector2d(-back, std::sin(3 * back));
    trails.record(1 - back, past);
  }
  return shown;
}

/// The same with all arrows, a selected weight whose draft is refused, and all tools.
inline ui::ShownScene marked(ui::ShownScene shown) {
  shown.marks.arrows = {.velocities = true, .forces = true, .tensions = true};
  core::Weight rejected = shown.scene.weights[2];
  rejected.rope->angle = 1;
  shown.marks.selection = ui::ShownSelection{2, true, {"Weight 3", "Angle 57°"}, rejected};
  shown.marks.tools.tape = ui::MeasuringTape{{1, 1}, {2.5, 0.6}};
  shown.marks.tools.protractor = ui::Protractor{{2, 2}, {3, 2}, {2, 2.5}};
  shown.marks.tools.stopwatch = ui::Stopwatch();
  for (core::WeightState& state : shown.runs[0].weights) {
    state.velocity = {0.5, 1};
    if (state.phase == core::Phase::kTethered) state.tension = 2;
  }
  return shown;
}

inline ui::SceneLook look(bool dark = false) {
  ui::SceneLook look{dark ? ui::Theme::darkTheme() : ui::Theme::light(), QFont("DejaVu Sans")};
  look.font.setPixelSize(16);
  return look;
}

/// The whole room of the scene in a picture of this size.
inline ui::Camera camera(const ui::ShownScene& shown, QSizeF size = {800, 600},
                         double devicePixelRatio = 1) {
  ui::Camera camera;
  camera.setViewport(size, devicePixelRatio);
  camera.fit({shown.scene.room.width, shown.scene.room.height},
             ui::sceneMargins(shown, look(), size.width()));
  return camera;
}

}  // namespace example
