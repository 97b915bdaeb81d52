#include "ui/control/trade_words.h"

#include <cmath>
#include <optional>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/trade/bounded_step.h"
#include "core/trade/work_precision.h"
#include "ui/chart/figure_text.h"
#include "ui/chart/log_scale.h"
#include "ui/control/quantity_text.h"
#include "ui/control/run_words.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::TradeWords)
};

constexpr double kNanoseconds = 1e-9;  // [s]

double inTwoDigits(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / digit) * digit;
}

/// Short steps as parts of a second, which can be compared at a glance.
QString roundedStep(double step) {
  if (step > 0.5) return Words::tr("%1 s").arg(quantityText(inTwoDigits(step)));
  return Words::tr("1/%1 s").arg(QLocale().toString(inTwoDigits(1 / step), 'f', 0));
}

QString neededWords(const core::Measurement& measurement, const core::MethodCurve& curve,
                    double error) {
  const QString name = methodWords(*curve.method);
  const std::optional<core::Reach> reach = core::reach(measurement, curve, error);
  if (!reach) return Words::tr("%1 gets nowhere near at the settings measured").arg(name);
  const QString needs = reachWords(measurement, curve, *reach);
  switch (reach->source) {
    case core::Reach::Source::kInterpolated:
      break;
    case core::Reach::Source::kCoarsest:
      return Words::tr("%1 needs no more than %2").arg(name, needs);
    case core::Reach::Source::kExtrapolated:
      return Words::tr("%1 would need %2 (extrapolated along its order)").arg(name, needs);
  }
  return Words::tr("%1 needs %2").arg(name, needs);
}

}  // namespace

QString measuredTimeWords(const core::Measurement& measurement) {
  const QString until = quantityText(std::round(measurement.until * 1000) / 1000);
  if (!measurement.endsEarly()) return Words::tr("Measured over %1 s.").arg(until);
  return Words::tr(
             "Measured over the first %1 s of %2 s: later not even the reference solution knows "
             "to 10⁻⁶ m where the weights are.")
      .arg(until, quantityText(measurement.wanted));
}

QString orderWords(const core::Measurement& measurement, const core::MethodCurve& curve) {
  const std::optional<core::ErrorLaw> law = core::errorLawOf(measurement, curve);
  const QString name = methodWords(*curve.method);
  if (!law) return Words::tr("%1: no order seen").arg(name);
  return Words::tr("%1: order %2").arg(name, QLocale().toString(law->order, 'f', 1));
}

QString settingWords(const core::Solver& solver) {
  const double setting = core::settingOf(solver);
  if (core::findMethod(solver.method)->isAdaptive) return figure(setting);
  return Words::tr("%1 s").arg(fractionText(setting));
}

QString reachWords(const core::Measurement& measurement, const core::MethodCurve& curve,
                   const core::Reach& reach) {
  const double computing = kNanoseconds * reach.nanosecondsPerSimulatedSecond * measurement.until;
  const QString cost = prefixedText(computing, QStringLiteral("s"));
  return curve.method->isAdaptive
             ? Words::tr("a tolerance of %1 and %2 of computing").arg(figure(reach.setting), cost)
             : Words::tr("a step of %1 and %2 of computing").arg(roundedStep(reach.setting), cost);
}

QString boundedStepWords(const std::vector<core::BoundedStep>& steps, double until) {
  QStringList limits;
  for (const core::BoundedStep& step : steps) {
    const QString name = methodWords(*step.method);
    if (!step.step) {
      limits << Words::tr("%1: none that was tried").arg(name);
    } else if (step.isUnlimited) {
      limits << Words::tr("%1: any").arg(name);
    } else {
      limits << Words::tr("%1: %2 s").arg(name, quantityText(*step.step));
    }
  }
  return Words::tr(
             "Largest step that stays bounded over %1 s, that is, makes less energy out of "
             "nothing than the scene has to move with. %2.")
      .arg(quantityText(until), limits.join(QStringLiteral("; ")));
}

QString foundWords(const core::Measurement& measurement, double error) {
  if (measurement.until <= 0) return Words::tr("No time was simulated.");
  QStringList needs;
  for (const core::MethodCurve& curve : measurement.curves) {
    needs << neededWords(measurement, curve, error);
  }
  return Words::tr("To be right within %1 over %2 s: %3.")
      .arg(prefixedText(error, QStringLiteral("m")),
           quantityText(std::round(measurement.until * 1000) / 1000),
           needs.join(QStringLiteral("; ")));
}

}  // namespace ui
