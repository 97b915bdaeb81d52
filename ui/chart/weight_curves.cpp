#include "ui/chart/weight_curves.h"

#include <utility>

#include <QCoreApplication>

#include "core/recording/motion_log.h"
#include "core/scene/arrangement.h"
#include "ui/style/theme.h"
#include "ui/view/scene_look.h"

namespace ui {

namespace {

constexpr double kBold = 3;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightChart)
};

QColor colorInScene(const core::Scene& scene, int weight, const Theme& theme) {
  const core::Color color = core::colorOf(scene, weight);
  return QColor(visibleInRoom(qRgb(color.red, color.green, color.blue), theme));
}

}  // namespace

std::vector<ChartCurve> weightCurves(const ChartSubject& subject, const Theme& theme,
                                     core::TimedPoint (*read)(const core::MotionSample&)) {
  const bool alone = subject.weights.size() == 1;
  std::vector<ChartCurve> curves;
  for (std::size_t run = 0; run < subject.runs.size(); ++run) {
    for (const int weight : subject.weights) {
      const core::MotionLog* motion = subject.runs[run].motion;
      const core::MotionLog::Track* track = motion ? motion->track(weight) : nullptr;
      if (track == nullptr) continue;
      ChartCurve curve;
      curve.name = weightName(weight);
      curve.run = run;
      const std::size_t place = subject.firstRun + run;
      curve.color = alone ? theme.runs[place % theme.runs.size()]
                          : colorInScene(*subject.scene, weight, theme);
      if (alone) curve.width = kBold;
      curve.points = pointsOf(*track, read);
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

ChartContent weightChart(const ChartSubject& subject, const Theme& theme, ChartAxis horizontal,
                         ChartAxis vertical, core::TimedPoint (*read)(const core::MotionSample&)) {
  ChartContent content;
  content.horizontal = std::move(horizontal);
  content.vertical = std::move(vertical);
  content.curves = weightCurves(subject, theme, read);
  const std::size_t inScene = subject.scene ? subject.scene->weights.size() : 0;
  const auto shown = static_cast<int>(subject.weights.size());
  if (shown > 1 && subject.weights.size() < inScene) {
    content.note = Words::tr("The first %1 of %2 weights").arg(shown).arg(inScene);
  }
  return content;
}

ChartAxis timeAxis() {
  return {Words::tr("Time"), Words::tr("s")};
}

QString weightName(int index) {
  return Words::tr("Weight %1").arg(index + 1);
}

}  // namespace ui
