#include "ui/chart/cut_sweep_result.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "ui/chart/figure_text.h"
#include "ui/control/quantity_text.h"
#include "ui/control/run_words.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::CutSweep)
};

QString number(double value, const QString& decimalPoint) {
  return QString::number(value, 'g', QLocale::FloatingPointShortest).replace('.', decimalPoint);
}

QString weightText(const CutSweepResult& result) {
  return QLocale().toString(result.question.weight + 1);
}

/// Where nothing hits, what comes nearest.
QString missWords(const CutSweepResult& result) {
  const core::Landing* nearest = nullptr;
  const auto missed = [&](const core::Landing& landing) {
    return result.target.missedBy(landing.place);
  };
  for (const core::Landing& landing : result.landings) {
    if (landing.outcome != core::LandingOutcome::kLanded) continue;
    if (!nearest || missed(landing) < missed(*nearest)) nearest = &landing;
  }
  if (!nearest) return Words::tr("Weight %1 never comes to the floor.").arg(weightText(result));
  return Words::tr("No cut makes weight %1 hit the target. The nearest is %2 m off, cut at %3 s.")
      .arg(weightText(result), figure(missed(*nearest)), cutTimeText(nearest->cutTime));
}

}  // namespace

QString cutTimeText(double time) {
  return QLocale().toString(time, 'f', 3);
}

QString firstHitWords(core::FirstHit hit) {
  switch (hit) {
    case core::FirstHit::kNothing:
      break;
    case core::FirstHit::kWall:
      return Words::tr("off a wall");
    case core::FirstHit::kWeight:
      return Words::tr("off a weight");
  }
  return {};
}

QString sweepNote(const CutSweepResult& result) {
  QString note = Words::tr("Weight %1, %2").arg(weightText(result), runWords(result.solver));
  if (result.landings.empty() || result.landings.back().cutTime < result.question.until)
    note += Words::tr("; the run cannot go on to the end");
  if (!result.isResolved) note += Words::tr("; there are more jumps than can be told apart");
  return note;
}

QString foundWords(const CutSweepResult& result) {
  if (result.hits.empty()) return missWords(result);
  double hitting = 0;
  for (const core::Hit& hit : result.hits) hitting += hit.until - hit.from;
  const double range = result.question.until - result.question.from;
  return Words::tr(
             "Of the cut times from %1 s to %2 s, %3 % hit the target. Click the chart, or "
             "double-click a row, to cut then.")
      .arg(quantityText(result.question.from), quantityText(result.question.until),
           figure(100 * hitting / range));
}

QString sweepTable(const CutSweepResult& result, QChar separator, const QString& decimalPoint) {
  const QStringList heading{Words::tr("Cut (s)"), Words::tr("Lands at (m)"),
                            Words::tr("Landing (s)"), Words::tr("On the way"),
                            Words::tr("On the target")};
  QString table = heading.join(separator) + '\n';
  for (const core::Landing& landing : result.landings) {
    QStringList cells{number(landing.cutTime, decimalPoint), {}, {}, {}, {}};
    if (landing.outcome == core::LandingOutcome::kLanded) {
      cells[1] = number(landing.place, decimalPoint);
      cells[2] = number(landing.time, decimalPoint);
      cells[3] = firstHitWords(landing.firstHit);
      cells[4] = result.target.holds(landing.place) ? QStringLiteral("1") : QStringLiteral("0");
    }
    table += cells.join(separator) + '\n';
  }
  return table;
}

}  // namespace ui
