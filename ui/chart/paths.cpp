#include "ui/chart/paths.h"

#include <QCoreApplication>

#include "core/recording/motion_log.h"
#include "ui/chart/weight_curves.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightChart)
};

core::TimedPoint place(const core::MotionSample& sample) {
  return {sample.time, sample.weight.position.x(), sample.weight.position.y()};
}

}  // namespace

ChartContent paths(const ChartSubject& subject, const Theme& theme) {
  ChartContent content = weightChart(subject, theme, {Words::tr("x"), Words::tr("m")},
                                     {Words::tr("y"), Words::tr("m")}, place);
  content.overTime = false;
  content.endsOnTicks = false;
  content.equalUnits = true;
  content.fromZero = true;
  return content;
}

}  // namespace ui
