#include "ui/chart/speed_over_time.h"

#include <QCoreApplication>

#include "core/recording/motion_log.h"
#include "ui/chart/weight_curves.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightChart)
};

core::TimedPoint speed(const core::MotionSample& sample) {
  return {sample.time, sample.time, sample.weight.velocity.norm()};
}

}  // namespace

ChartContent speedOverTime(const ChartSubject& subject, const Theme& theme) {
  ChartContent content =
      weightChart(subject, theme, timeAxis(), {Words::tr("Speed"), Words::tr("m/s")}, speed);
  content.fromZero = true;
  return content;
}

}  // namespace ui
