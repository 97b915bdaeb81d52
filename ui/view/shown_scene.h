#pragma once

#include <memory>
#include <vector>

#include <QRgb>
#include <QString>

#include "core/run/run.h"
#include "core/scene/scene.h"

namespace ui {

/// One run at one moment.
struct ShownRun {
  QString name;  ///< method and step, for the legend
  std::vector<core::WeightState> weights;
};

/// All that is needed to draw runs of one scene at one moment; plain values.
struct ShownScene {
  core::Scene scene;
  std::vector<QRgb> colors;    ///< one per weight
  double time = 0;             ///< [s]
  std::vector<ShownRun> runs;  ///< the first is drawn filled, the others as outlines
};

/// The scene of these runs, with their names, each as it stands now.
/// @pre all runs are of one scene
ShownScene shownScene(const std::vector<const core::Run*>& runs);

/// Reads where the weights are at another moment; the vectors keep their memory.
/// @param time  [s], inside the latest step of every run
void readWeights(const std::vector<const core::Run*>& runs, double time, ShownScene& shown);

/// A run's method and step or tolerance as a person would say it: "Euler, 1/60 s".
QString solverText(const core::Run& run);

}  // namespace ui
