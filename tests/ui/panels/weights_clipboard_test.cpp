#include "ui/panels/weights_clipboard.h"

#include <numbers>
#include <numeric>

#include <QLocale>
#include <QTest>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"

using ui::WeightColumn;

namespace {

/// Two on ropes, a rod, and a free one.
core::Scene mixedScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.weights[0].rope->angle = 70 * std::numbers::pi / 180;
  scene.weights[1].color = core::Color{0x12, 0x34, 0x56};
  scene.weights[2].rope->rigid = true;
  core::Weight free;
  free.position = {0.5, 0.25};
  free.velocity = {-1.5, 2};
  scene.weights.push_back(free);
  return scene;
}

std::vector<int> allRows(const core::Scene& scene) {
  std::vector<int> rows(scene.weights.size());
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

ui::ColumnStretch only(WeightColumn column) {
  return {static_cast<int>(column), static_cast<int>(column)};
}

ui::PastePlace at(int row, WeightColumn column) {
  return {{}, row, only(column)};
}

}  // namespace

class WeightsClipboardTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QLocale::setDefault(QLocale::c()); }
  void wholeRowsComeBackAsTheyWere_data();
  void wholeRowsComeBackAsTheyWere();
  void takesNumbersOfEveryLocale_data();
  void takesNumbersOfEveryLocale();
  void someCellsHaveNoHeadings();
  void oneValueGoesToAllSelectedRows();
  void rowsBeyondTheLastAreNewWeights();
  void newWeightsWithoutAPlaceStandBesideTheOthers();
  void hangsUpAndTakesDownWhereTheWeightIs();
  void aRopeAndItsCellsComeInOneRow();
  void refusesWhatMakesNoSense_data();
  void refusesWhatMakesNoSense();
  void refusesMoreWeightsThanThereMayBe();
};

void WeightsClipboardTest::wholeRowsComeBackAsTheyWere_data() {
  QTest::addColumn<QLocale>("locale");
  QTest::newRow("point") << QLocale::c();
  QTest::newRow("comma") << QLocale(QLocale::German);
}

void WeightsClipboardTest::wholeRowsComeBackAsTheyWere() {
  QFETCH(QLocale, locale);
  QLocale::setDefault(locale);
  const core::Scene scene = mixedScene();
  const QString text = ui::cellsText(scene, allRows(scene), {});
  QVERIFY(text.startsWith("Mass [kg]\tRadius [m]\tDrag coefficient\tColor\tHangs on\t"));
  QVERIFY(text.contains(locale.decimalPoint()));
  core::Scene other = scene;
  for (core::Weight& weight : other.weights) weight = core::Weight();
  // Wherever the current cell is: headings and whole rows know where they belong.
  const auto pasted = ui::withPasted(other, text, at(0, WeightColumn::kAngle));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QVERIFY(*pasted.scene == scene);
  QCOMPARE(pasted.rowCount, 4);
  QCOMPARE(pasted.addedCount, 0);
}

void WeightsClipboardTest::takesNumbersOfEveryLocale_data() {
  QTest::addColumn<QString>("text");
  QTest::newRow("point") << "0.25";
  QTest::newRow("comma") << "0,25";
  QTest::newRow("exponent") << "2.5E-1";
  QTest::newRow("fraction") << "1/4";
  QTest::newRow("unit") << "0.25 kg";
  QTest::newRow("quotes") << "\"0,25\"";
  QTest::newRow("a line's end as on Windows") << "0.25\r\n";
}

void WeightsClipboardTest::takesNumbersOfEveryLocale() {
  QFETCH(QString, text);
  const auto pasted = ui::withPasted(mixedScene(), text, at(1, WeightColumn::kMass));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QCOMPARE(pasted.scene->weights[1].mass, 0.25);
  QCOMPARE(pasted.scene->weights[0].mass, 0.19);
}

void WeightsClipboardTest::someCellsHaveNoHeadings() {
  const QString text = ui::cellsText(mixedScene(), {0, 3}, {7, 8});
  QCOMPARE(text, QString("1\t70\n\t\n"));
}

void WeightsClipboardTest::oneValueGoesToAllSelectedRows() {
  const auto pasted =
      ui::withPasted(mixedScene(), "30", {{0, 2, 3}, 0, only(WeightColumn::kAngle)});
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QCOMPARE(pasted.rowCount, 2);  // a free weight has no angle
  QCOMPARE(pasted.scene->weights[0].rope->angle, std::numbers::pi / 6);
  QCOMPARE(pasted.scene->weights[1].rope->angle, 0.0);
  QCOMPARE(pasted.scene->weights[2].rope->angle, std::numbers::pi / 6);
}

void WeightsClipboardTest::rowsBeyondTheLastAreNewWeights() {
  const auto pasted =
      ui::withPasted(mixedScene(), "0.6\t0.3\n0.7\t0.35\n0.8\t0.4", at(3, WeightColumn::kX));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QCOMPARE(pasted.addedCount, 2);
  QCOMPARE(pasted.scene->weights.size(), std::size_t{6});
  QCOMPARE(pasted.scene->weights[5].position, Eigen::Vector2d(0.8, 0.4));
  QCOMPARE(pasted.scene->weights[5].velocity, Eigen::Vector2d(-1.5, 2));  // as the last one
}

void WeightsClipboardTest::newWeightsWithoutAPlaceStandBesideTheOthers() {
  const auto pasted = ui::withPasted(mixedScene(), "1\n2\n3", at(4, WeightColumn::kMass));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QCOMPARE(pasted.scene->weights.size(), std::size_t{7});
  QCOMPARE(pasted.scene->weights[6].mass, 3.0);
  QVERIFY(core::problemsIn(*pasted.scene).empty());
}

void WeightsClipboardTest::hangsUpAndTakesDownWhereTheWeightIs() {
  const core::Scene scene = mixedScene();
  const auto pasted =
      ui::withPasted(scene, "nothing\nRod\nrope\nrope", at(0, WeightColumn::kHangsOn));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  const auto& weights = pasted.scene->weights;
  QVERIFY(!weights[0].rope);
  QVERIFY(weights[1].rope->rigid);
  QVERIFY(!weights[2].rope->rigid);
  QVERIFY(weights[3].rope.has_value());
  for (int i : {0, 3}) {
    const Eigen::Vector2d way =
        core::startPosition(weights[i]) - core::startPosition(scene.weights[i]);
    QVERIFY(way.norm() < 1e-15);  // sine and cosine of the angle, rounded
  }
  // A rope hands on what goes along it at a right angle.
  QCOMPARE(core::startVelocity(weights[3]).x(), -1.5);
}

void WeightsClipboardTest::aRopeAndItsCellsComeInOneRow() {
  const auto pasted =
      ui::withPasted(mixedScene(), "rope\t2\t3\t1.5\t-20\t0", at(3, WeightColumn::kHangsOn));
  QVERIFY2(pasted.scene, qPrintable(pasted.refusal));
  QCOMPARE(pasted.scene->weights[3].rope->length, 1.5);
  QCOMPARE(pasted.scene->weights[3].rope->pivot, Eigen::Vector2d(2, 3));
}

void WeightsClipboardTest::refusesWhatMakesNoSense_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("row");
  QTest::addColumn<int>("column");
  QTest::addColumn<QString>("refusal");
  const auto name = [](WeightColumn column) { return static_cast<int>(column); };
  QTest::newRow("words for a number")
      << "1\nheavy" << 0 << name(WeightColumn::kMass)
      << "Weight 2, Mass: must be from 1e-6 to 1e9\u00a0kg, got “heavy”";
  QTest::newRow("out of range") << "0.1\t11" << 2 << name(WeightColumn::kRadius)
                                << "Weight 3, Drag coefficient: must be from 0 to 10, got “11”";
  QTest::newRow("nothing") << "1\n\n3" << 0 << name(WeightColumn::kMass)
                           << "Weight 2, Mass: is empty";
  QTest::newRow("a position on a rope") << "0.3" << 0 << name(WeightColumn::kX)
                                        << "Weight 1, x: a weight on a rope has none, got “0.3”";
  QTest::newRow("an angle without a rope")
      << "0.3" << 3 << name(WeightColumn::kAngle)
      << "Weight 4, Start angle: a weight that hangs on nothing has none, got “0.3”";
  QTest::newRow("no color") << "reddish" << 0 << name(WeightColumn::kColor)
                            << "Weight 1, Color: must be like #e69f00, or automatic, got “reddish”";
  QTest::newRow("no holding") << "chain" << 0 << name(WeightColumn::kHangsOn)
                              << "Weight 1, Hangs on: must be rope, rod or nothing, got “chain”";
  QTest::newRow("rows of uneven length")
      << "1\t0.1\n2" << 0 << name(WeightColumn::kMass)
      << "Line 2 has another number of columns than the first (1, not 2).";
  QTest::newRow("too many columns")
      << "1\t2\t3" << 0 << name(WeightColumn::kVelocityX)
      << "There are too many columns: 3, and from Velocity x on the table has 2.";
  QTest::newRow("an empty clipboard")
      << "" << 0 << name(WeightColumn::kMass) << "The clipboard holds no text.";
  QTest::newRow("headings alone") << "Mass [kg]\tRadius [m]" << 0 << name(WeightColumn::kMass)
                                  << "There are only headings.";
}

void WeightsClipboardTest::refusesWhatMakesNoSense() {
  QFETCH(QString, text);
  QFETCH(int, row);
  QFETCH(int, column);
  QFETCH(QString, refusal);
  const auto pasted =
      ui::withPasted(mixedScene(), text, at(row, static_cast<WeightColumn>(column)));
  QVERIFY(!pasted.scene);
  QCOMPARE(pasted.refusal, refusal);
}

void WeightsClipboardTest::refusesMoreWeightsThanThereMayBe() {
  const QString text = QString("1\n").repeated(core::kMostWeights);
  const auto pasted = ui::withPasted(mixedScene(), text, at(1, WeightColumn::kMass));
  QCOMPARE(pasted.refusal, QString("There would be more than 100000 weights."));
}

QTEST_GUILESS_MAIN(WeightsClipboardTest)
#include "weights_clipboard_test.moc"
