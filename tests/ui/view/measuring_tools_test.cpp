#include "ui/view/measuring_tools.h"

#include <cmath>
#include <numbers>

#include <QLocale>
#include <QTest>

#include "tests/ui/view/example_scenes.h"

using Eigen::Vector2d;
using ui::ToolPart;

namespace {

constexpr double kTop = 40;  // px

ui::Camera roomCamera() {
  return example::camera(example::freeWeights(1, 0.02, 0));
}

ui::MeasuringTools allTools() {
  ui::MeasuringTools tools;
  tools.tape = ui::MeasuringTape{{1, 1}, {2.5, 0.6}};
  tools.protractor = ui::Protractor{{2, 2}, {3, 2}, {2, 2.5}};
  tools.stopwatch = ui::Stopwatch();
  return tools;
}

QStringList words(const ui::MeasuringTools& tools, double time = 0) {
  ui::Drawing drawing;
  ui::drawTools(tools, time, kTop, roomCamera(), example::look(), drawing);
  QStringList all;
  for (const ui::Text& text : drawing.texts) all << text.words;
  return all;
}

QPointF place(const ui::MeasuringTools& tools, ToolPart part) {
  return ui::placeOf(tools, part, kTop, roomCamera(), example::look());
}

std::optional<ToolPart> partAt(const ui::MeasuringTools& tools, QPointF pixel) {
  return ui::toolPartAt(tools, pixel, kTop, roomCamera(), example::look());
}

void move(ui::MeasuringTools& tools, ToolPart part, QPointF pixel) {
  ui::movePart(tools, part, pixel, kTop, roomCamera(), example::look());
}

}  // namespace

class MeasuringToolsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void theTapeTellsItsLengthAndWhereItLeads();
  void theProtractorTellsTheSmallerAngle_data();
  void theProtractorTellsTheSmallerAngle();
  void theStopwatchTellsWhatLiesBetweenStartAndStop();
  void theStopwatchCountsBackWithTime();
  void partsAreFoundWhereTheyAre();
  void endsMoveAloneAndWholesTogether();
  void theStopwatchStaysInThePicture();
};

void MeasuringToolsTest::theTapeTellsItsLengthAndWhereItLeads() {
  ui::MeasuringTools tools;
  tools.tape = ui::MeasuringTape{{1, 1}, {1.3, 0.6}};
  // One pixel is about 6 mm: millimetres are read.
  QCOMPARE(words(tools), QStringList({"Δx 0.300\u00a0m, Δy −0.400\u00a0m", "0.500\u00a0m"}));
}

void MeasuringToolsTest::theProtractorTellsTheSmallerAngle_data() {
  QTest::addColumn<double>("first");
  QTest::addColumn<double>("second");
  QTest::addColumn<QString>("expected");
  QTest::newRow("right") << 0.0 << 90.0 << "90.0°";
  QTest::newRow("the other way round") << 90.0 << 0.0 << "90.0°";
  QTest::newRow("across the left") << 170.0 << -160.0 << "30.0°";
  QTest::newRow("straight") << 20.0 << 200.0 << "180.0°";
  QTest::newRow("none") << 45.0 << 45.0 << "0.0°";
}

void MeasuringToolsTest::theProtractorTellsTheSmallerAngle() {
  QFETCH(double, first);
  QFETCH(double, second);
  QFETCH(QString, expected);
  const auto arm = [](double degrees) -> Vector2d {
    const double angle = degrees * std::numbers::pi / 180;
    return Vector2d(2, 1.5) + Vector2d(std::cos(angle), std::sin(angle));
  };
  ui::MeasuringTools tools;
  tools.protractor = ui::Protractor{{2, 1.5}, arm(first), arm(second)};
  QCOMPARE(words(tools), QStringList(expected));
}

void MeasuringToolsTest::theStopwatchTellsWhatLiesBetweenStartAndStop() {
  ui::Stopwatch watch;
  watch.startOrStop(1.25);
  QCOMPARE(watch.reading(2), 0.75);
  watch.startOrStop(2.5);
  QCOMPARE(watch.reading(7), 1.25);
  watch.startOrStop(10);  // goes on counting
  watch.startOrStop(11);
  QCOMPARE(watch.reading(20), 2.25);
  ui::MeasuringTools tools;
  tools.stopwatch = watch;
  QVERIFY(words(tools, 30).contains("2.250 s"));
  tools.stopwatch->setToZero(30);
  QVERIFY(!tools.stopwatch->isRunning());
  QVERIFY(words(tools, 31).contains("0.000 s"));
}

void MeasuringToolsTest::theStopwatchCountsBackWithTime() {
  ui::Stopwatch watch;
  watch.startOrStop(2);
  QCOMPARE(watch.reading(1.5), -0.5);
  watch.setToZero(1.5);
  QCOMPARE(watch.reading(1.75), 0.25);
}

void MeasuringToolsTest::partsAreFoundWhereTheyAre() {
  const ui::MeasuringTools tools = allTools();
  for (const ToolPart part : ui::partsOf(tools)) {
    const QPointF at = place(tools, part) + QPointF(4, 4);
    QCOMPARE(partAt(tools, at), part);
  }
  QCOMPARE(ui::partsOf(tools).size(), std::size_t{7});
  QCOMPARE(partAt(tools, roomCamera().toPixels({0.5, 2.5})), std::nullopt);
  QCOMPARE(partAt(ui::MeasuringTools(), place(tools, ToolPart::kVertex)), std::nullopt);
}

void MeasuringToolsTest::endsMoveAloneAndWholesTogether() {
  const QPointF to = roomCamera().toPixels({1.5, 1.5});
  ui::MeasuringTools tools = allTools();
  move(tools, ToolPart::kTapeTo, to);
  QVERIFY((tools.tape->to - Vector2d(1.5, 1.5)).norm() < 1e-9);
  QCOMPARE(tools.tape->from, Vector2d(1, 1));
  tools = allTools();
  move(tools, ToolPart::kTape, to);  // its middle
  QVERIFY((tools.tape->from - Vector2d(0.75, 1.7)).norm() < 1e-9);
  QVERIFY((tools.tape->to - Vector2d(2.25, 1.3)).norm() < 1e-9);
  move(tools, ToolPart::kVertex, to);
  QVERIFY((tools.protractor->first - Vector2d(2.5, 1.5)).norm() < 1e-9);
  QVERIFY((tools.protractor->second - Vector2d(1.5, 2)).norm() < 1e-9);
  move(tools, ToolPart::kFirstArm, roomCamera().toPixels({1.5, 0}));
  QVERIFY(std::abs(tools.protractor->angle() - std::numbers::pi) < 1e-9);
}

void MeasuringToolsTest::theStopwatchStaysInThePicture() {
  ui::MeasuringTools tools = allTools();
  for (const QPointF to : {QPointF(-500, -500), QPointF(5000, 5000), QPointF(300, 200)}) {
    move(tools, ToolPart::kStopwatch, to);
    const QRectF face = ui::stopwatchFace(*tools.stopwatch, kTop, roomCamera(), example::look());
    QVERIFY(QRectF(0, kTop, 800, 600 - kTop).contains(face));
  }
  QVERIFY((place(tools, ToolPart::kStopwatch) - QPointF(300, 200)).manhattanLength() < 1e-9);
}

QTEST_MAIN(MeasuringToolsTest)
#include "measuring_tools_test.moc"
