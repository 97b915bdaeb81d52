#include "ui/view/shown_scene.h"

#include "core/scene/arrangement.h"
#include "ui/control/run_words.h"

namespace ui {

namespace {

QRgb rgbOf(core::Color color) {
  return qRgb(color.red, color.green, color.blue);
}

}  // namespace

ShownScene shownScene(const std::vector<const core::Run*>& runs, std::size_t firstPlace) {
  ShownScene shown;
  if (runs.empty()) return shown;
  shown.scene = runs.front()->scene();
  const int count = runs.front()->weightCount();
  shown.colors.reserve(count);
  for (int i = 0; i < count; ++i) shown.colors.push_back(rgbOf(core::colorOf(shown.scene, i)));
  shown.time = runs.front()->time();
  for (const core::Run* run : runs) {
    const std::size_t place = firstPlace + shown.runs.size();
    shown.runs.push_back({runWords(run->solver()), place, {}});
    for (int i = 0; i < count; ++i) shown.runs.back().weights.push_back(run->weight(i));
  }
  return shown;
}

void readWeights(const std::vector<const core::Run*>& runs, double time, ShownScene& shown) {
  shown.time = time;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    std::vector<core::WeightState>& weights = shown.runs[r].weights;
    weights.resize(runs[r]->weightCount());
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = runs[r]->weightAt(static_cast<int>(i), time);
  }
}

}  // namespace ui
