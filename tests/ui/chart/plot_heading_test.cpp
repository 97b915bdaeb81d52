#include "ui/chart/plot_heading.h"

#include <QLocale>
#include <QTest>

#include "tests/ui/chart/sample_ledgers.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_scales.h"
#include "ui/chart/energy_extent.h"
#include "ui/style/theme.h"

using core::Ledger;
using ui::ChartedRun;
using ui::HeadingContent;
using ui::HeadingEntry;

namespace {

HeadingContent headingOf(const std::vector<ChartedRun>& runs, const ui::HiddenCurves& hidden = {},
                         std::size_t firstRun = 0) {
  const ui::EnergyExtent extent = ui::extentOf(runs);
  const ui::ChartSubject subject{runs, nullptr, {}, firstRun};
  const ui::ChartContent content = ui::energyChartKind().content(subject, ui::Theme::light());
  std::vector<bool> shown;
  for (const ui::ChartCurve& curve : content.curves) shown.push_back(extent.shown[*curve.quantity]);
  const double top = extent.ceiling.value_or(extent.highest);
  const ui::AxisScale energy = ui::axisScale(content.vertical, 0, top, 5, ui::AxisEnds::kOnTicks);
  return ui::plotHeading(subject, content, shown, hidden, extent, energy, ui::Theme::light());
}

QStringList textsOf(const std::vector<HeadingEntry>& entries) {
  QStringList texts;
  for (const HeadingEntry& entry : entries) texts.append(entry.text);
  return texts;
}

}  // namespace

class PlotHeadingTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }
  void namesEachQuantityOnceForAllRuns();
  void marksRunsByLineStyle();
  void aRunAloneKeepsItsMark();
  void statesTheDriftInJoulesAndPercentOfTheStart();
  void statesDriftsFarBelowAPixel();
  void saysWhatWasTakenOffPotentialAndTotal();
  void saysWhereTheScaleEnds();
  void strikesOutWhatIsHidden();
};

void PlotHeadingTest::namesEachQuantityOnceForAllRuns() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  const HeadingContent heading = headingOf({{&ledger, "RK4"}, {&ledger, "Euler"}});
  QCOMPARE(textsOf(heading.legend),
           QStringList({"Kinetic", "Potential", "Lost to air", "Lost to impacts", "Total"}));
  QCOMPARE(textsOf(heading.runs), QStringList({"RK4", "Euler"}));
  QCOMPARE(heading.warning, QString());
}

void PlotHeadingTest::marksRunsByLineStyle() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  const HeadingContent heading = headingOf({{&ledger, "RK4"}, {&ledger, "Euler"}});
  QCOMPARE(heading.runs[0].line.style(), Qt::SolidLine);
  QCOMPARE(heading.runs[1].line.style(), Qt::CustomDashLine);
  QVERIFY(heading.runs[0].markFilled);
  QVERIFY(!heading.runs[1].markFilled);
  QCOMPARE(heading.runs[1].mark, ui::Theme::light().runs[1]);
}

void PlotHeadingTest::aRunAloneKeepsItsMark() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  const std::vector<HeadingEntry> both = headingOf({{&ledger, "RK4"}, {&ledger, "Euler"}}).runs;
  const HeadingEntry alone = headingOf({{&ledger, "Euler"}}, {}, 1).runs.front();
  QCOMPARE(alone.mark, both[1].mark);
  QCOMPARE(alone.markFilled, both[1].markFilled);
  QCOMPARE(alone.line, both[1].line);
  QVERIFY(alone.line != both[0].line);
}

void PlotHeadingTest::statesTheDriftInJoulesAndPercentOfTheStart() {
  const Ledger ledger = sample_ledgers::swinging(4, 401, 1, 0.15);  // 0.6 J on top of 3 J
  QCOMPARE(headingOf({{&ledger, "Euler"}}).runs[0].figures,
           QStringLiteral("drift +0.600 J (+20.0 %)"));
}

void PlotHeadingTest::statesDriftsFarBelowAPixel() {
  const Ledger ledger = sample_ledgers::swinging(4, 401, 1, -1.5e-12);
  QCOMPARE(headingOf({{&ledger, "RK4"}}).runs[0].figures,
           QStringLiteral("drift −6.0·10⁻¹² J (−2.0·10⁻¹⁰ %)"));
}

void PlotHeadingTest::saysWhatWasTakenOffPotentialAndTotal() {
  const Ledger ledger = sample_ledgers::swinging(4, 401, 1862.3);
  QCOMPARE(textsOf(headingOf({{&ledger, "RK4"}}).legend),
           QStringList({"Kinetic", "Potential − 1,862 J", "Lost to air", "Lost to impacts",
                        "Total − 1,862 J"}));
}

void PlotHeadingTest::saysWhereTheScaleEnds() {
  const Ledger steady = sample_ledgers::swinging(4, 401);
  const Ledger diverging = sample_ledgers::diverging();
  const HeadingContent heading = headingOf({{&steady, "RK4"}, {&diverging, "Euler"}});
  QCOMPARE(heading.warning, QStringLiteral("Scale ends at 30 J: Euler reaches 2.2·10³⁰⁷ J."));
  QCOMPARE(heading.runs[1].figures, QStringLiteral("drift +2.2·10³⁰⁷ J"));
}

void PlotHeadingTest::strikesOutWhatIsHidden() {
  const Ledger ledger = sample_ledgers::swinging(4, 401);
  const HeadingContent heading =
      headingOf({{&ledger, "RK4"}, {&ledger, "Euler"}}, {{"Potential"}, {1}});
  for (const HeadingEntry& entry : heading.legend) {
    QCOMPARE(entry.hidden, entry.text == "Potential");
    QCOMPARE(entry.key, entry.text);
  }
  QVERIFY(!heading.runs[0].hidden);
  QVERIFY(heading.runs[1].hidden);
}

QTEST_GUILESS_MAIN(PlotHeadingTest)
#include "plot_heading_test.moc"
