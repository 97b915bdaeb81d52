#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QRgb>
#include <QString>

#include "core/run/run.h"
#include "core/scene/scene.h"
#include "ui/view/scene_marks.h"
#include "ui/view/shown_step.h"
#include "ui/view/shown_target.h"

namespace ui {

/// One run at one moment.
struct ShownRun {
  QString name;           ///< method and step, for the legend
  std::size_t place = 0;  ///< among all runs of the scene: decides its mark in the legend
  std::vector<core::WeightState> weights;
};

/// All that is needed to draw runs of one scene at one moment; plain values.
struct ShownScene {
  core::Scene scene;
  std::vector<QRgb> colors;    ///< one per weight
  double time = 0;             ///< [s]
  std::vector<ShownRun> runs;  ///< the first is drawn filled, the others as outlines
  std::optional<ShownStep> step = std::nullopt;  ///< opened up
  SceneMarks marks = {};
  std::optional<ShownTarget> target = std::nullopt;
};

/// The scene of these runs, with their names, each as it stands now.
/// @param firstPlace  of the first of them among all runs of the scene
/// @pre all runs are of one scene
ShownScene shownScene(const std::vector<const core::Run*>& runs, std::size_t firstPlace = 0);

/// Reads where the weights are at another moment; the vectors keep their memory.
/// @param time  [s], inside the latest step of every run
void readWeights(const std::vector<const core::Run*>& runs, double time, ShownScene& shown);

}  // namespace ui
