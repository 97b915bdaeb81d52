#include "app/measure_table.h"

#include <optional>

#include <QCoreApplication>
#include <QStringList>

#include "core/trade/work_precision.h"
#include "ui/control/run_words.h"
#include "ui/control/trade_words.h"

namespace app {
namespace {

constexpr double kPlainError = 1e-3;  // [m] of the sentence
constexpr double kTableError = 1e-6;  // [m] of the table
constexpr int kNameWidth = 26;
constexpr int kColumnWidth = 14;

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::MeasureTable)
};

QString number(double value, int digits) {
  return QString::number(value, 'g', digits).rightJustified(kColumnWidth);
}

QString sourceWords(core::Reach::Source source) {
  switch (source) {
    case core::Reach::Source::kInterpolated:
      break;
    case core::Reach::Source::kCoarsest:
      return Texts::tr("at most");
    case core::Reach::Source::kExtrapolated:
      return Texts::tr("extrapolated");
  }
  return {};
}

QString header() {
  QString line = Texts::tr("method").leftJustified(kNameWidth);
  for (const QString& name : {Texts::tr("order"), Texts::tr("least error"), Texts::tr("setting"),
                              Texts::tr("ns per s")}) {
    line += name.rightJustified(kColumnWidth);
  }
  return line + '\n';
}

QString rowOf(const core::Measurement& measurement, const core::MethodCurve& curve) {
  const QString missing = QStringLiteral("–").rightJustified(kColumnWidth);
  QString line = ui::methodWords(*curve.method).leftJustified(kNameWidth);
  const std::optional<core::ErrorLaw> law = core::errorLawOf(measurement, curve);
  line += law ? QString::number(law->order, 'f', 2).rightJustified(kColumnWidth) : missing;
  double least = curve.points.front().maxPositionError;
  for (const core::MeasuredPoint& point : curve.points) {
    if (point.isComplete()) least = std::min(least, point.maxPositionError);
  }
  line += number(least, 2);
  const std::optional<core::Reach> reach = core::reach(measurement, curve, kTableError);
  if (!reach) return line + missing + missing + '\n';
  line += number(reach->setting, 3) + number(reach->nanosecondsPerSimulatedSecond, 3);
  const QString source = sourceWords(reach->source);
  return line + (source.isEmpty() ? QString() : QStringLiteral("  ") + source) + '\n';
}

}  // namespace

QString measureTable(const core::Measurement& measurement) {
  QString text = ui::measuredTimeWords(measurement) + '\n';
  text += Texts::tr(
      "Order: the power of the step that the position error falls with. Setting (step in s, or "
      "tolerance)\nand cost (ns of computing per simulated second): to be right within 1e-6 "
      "m.\n\n");
  text += header();
  for (const core::MethodCurve& curve : measurement.curves) text += rowOf(measurement, curve);
  return text + '\n' + ui::foundWords(measurement, kPlainError) + '\n';
}

}  // namespace app
