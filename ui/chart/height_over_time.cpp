#include "ui/chart/height_over_time.h"

#include <QCoreApplication>

#include "core/recording/motion_log.h"
#include "ui/chart/weight_curves.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightChart)
};

core::TimedPoint height(const core::MotionSample& sample) {
  return {sample.time, sample.time, sample.weight.position.y()};
}

}  // namespace

ChartContent heightOverTime(const ChartSubject& subject, const Theme& theme) {
  ChartContent content =
      weightChart(subject, theme, timeAxis(), {Words::tr("Height"), Words::tr("m")}, height);
  content.fromZero = true;
  return content;
}

}  // namespace ui
