#include "ui/chart/phase_portrait.h"

#include <limits>
#include <numbers>

#include <QCoreApplication>

#include "core/recording/motion_log.h"
#include "ui/chart/weight_curves.h"

namespace ui {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightChart)
};

core::TimedPoint angleAndAngularVelocity(const core::MotionSample& sample) {
  const core::WeightState& weight = sample.weight;
  if (weight.phase != core::Phase::kTethered) return {sample.time, kNothing, kNothing};
  return {sample.time, weight.angle * kDegreesPerRadian,
          weight.angularVelocity * kDegreesPerRadian};
}

}  // namespace

ChartContent phasePortrait(const ChartSubject& subject, const Theme& theme) {
  ChartContent content =
      weightChart(subject, theme, {Words::tr("θ"), Words::tr("°"), false},
                  {Words::tr("ω"), Words::tr("°/s"), false}, angleAndAngularVelocity);
  content.overTime = false;
  content.endsOnTicks = false;
  return content;
}

}  // namespace ui
