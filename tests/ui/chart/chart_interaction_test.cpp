#include <cmath>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/chart/sample_ledgers.h"
#include "tests/ui/chart/shown_chart.h"

using core::Ledger;
using shown_chart::curveNamed;
using shown_chart::drag;
using shown_chart::placeOfEntry;
using shown_chart::pointsOf;
using shown_chart::ShownChart;
using shown_chart::turnWheel;
using ui::ChartWidget;

namespace {

constexpr int kPhase = 2;
constexpr int kPaths = 3;

bool isNear(double value, double expected, double tolerance) {
  return std::abs(value - expected) <= tolerance;
}

void hover(ChartWidget& chart, QPoint place) {
  QMouseEvent move(QEvent::MouseMove, place, chart.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(&chart, &move);
}

}  // namespace

/// What hands do with a chart: mouse, wheel and keys on the real widget.
class ChartInteractionTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void zoomsAboutThePointer();
  void zoomsAlongOneAxisBesideIt_data();
  void zoomsAlongOneAxisBesideIt();
  void showsAllAgainWhenZoomedOutFarEnough();
  void zoomsToABoxThatIsDrawn();
  void movesWithShiftAndTheMiddleButton_data();
  void movesWithShiftAndTheMiddleButton();
  void resets_data();
  void resets();
  void zoomsAndMovesByKey();
  void takesItsKeysBeforeTheWindow();
  void picksAMomentByClick();
  void dragsTheTimeLine();
  void picksTheNearestMomentOfAPath();
  void hidesCurvesAndRunsByClickInTheLegend();
  void keepsZoomAndHiddenCurvesWhenTheSceneRestarts();
  void readsOffUnderThePointer();
  void showsTheMomentWithoutReadingTheRecordAnew();
  void copiesAPictureForPaper();
  void copiesATable();
  void asksForItsMenuByMouseAndKey();
  void drawsCirclesRound();

 private:
  Ledger m_first = sample_ledgers::swinging(8, 801);
  Ledger m_second = sample_ledgers::swinging(8, 801, 1, 0.1);
  std::vector<ui::ChartedRun> m_runs = {{&m_first, "RK4"}, {&m_second, "Euler"}};
};

void ChartInteractionTest::zoomsAboutThePointer() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QRectF before = chart.shown();
  const QPoint place = chart.placeOf({6, 1});
  turnWheel(chart, place, 3);
  QVERIFY(isNear(chart.shown().width(), before.width() / std::pow(1.2, 3), 1e-9));
  QVERIFY(isNear(chart.shown().height(), before.height() / std::pow(1.2, 3), 1e-9));
  chart.grab();
  QVERIFY((chart.placeOf({6, 1}) - place).manhattanLength() <= 12);  // labels may have moved it
  for (const ui::DrawnCurve& curve : chart.plot().drawn()) {
    for (const QPolygonF& line : curve.lines) {
      const QRectF shown = chart.shown().adjusted(-1e-9, -1e-9, 1e-9, 1e-9);
      QVERIFY(shown.contains(line.first()) && shown.contains(line.last()));
    }
  }
}

void ChartInteractionTest::zoomsAlongOneAxisBesideIt_data() {
  QTest::addColumn<bool>("besideTime");
  QTest::addColumn<bool>("alongX");
  QTest::newRow("below the plot") << true << true;
  QTest::newRow("left of the plot") << false << false;
}

void ChartInteractionTest::zoomsAlongOneAxisBesideIt() {
  QFETCH(bool, besideTime);
  QFETCH(bool, alongX);
  ShownChart chart;
  chart.setRuns(m_runs);
  const QRectF before = chart.shown();
  const QPointF place = besideTime ? QPointF(chart.plotArea().center().x(), chart.height() - 8)
                                   : QPointF(8, chart.plotArea().center().y());
  turnWheel(chart, place, 2);
  QCOMPARE(chart.shown().width() < before.width(), alongX);
  QCOMPARE(chart.shown().height() < before.height(), !alongX);
}

void ChartInteractionTest::showsAllAgainWhenZoomedOutFarEnough() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QRectF all = chart.shown();
  turnWheel(chart, chart.plotArea().center(), 3);
  QVERIFY(chart.plot().zoom().has_value());
  turnWheel(chart, chart.plotArea().center(), -4);
  QVERIFY(!chart.plot().zoom().has_value());
  QCOMPARE(chart.shown(), all);
}

void ChartInteractionTest::zoomsToABoxThatIsDrawn() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QPoint from = chart.placeOf({2, 2});
  const QPoint to = chart.placeOf({4, 1});
  drag(chart, from, to);
  // A pixel is 8 s / 500 wide, and labels may move the plot by some.
  QVERIFY(isNear(chart.shown().left(), 2, 0.05) && isNear(chart.shown().right(), 4, 0.05));
  QVERIFY(isNear(chart.shown().top(), 1, 0.05) && isNear(chart.shown().bottom(), 2, 0.05));
}

void ChartInteractionTest::movesWithShiftAndTheMiddleButton_data() {
  QTest::addColumn<Qt::MouseButton>("button");
  QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
  QTest::newRow("shift") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
  QTest::newRow("middle button") << Qt::MiddleButton << Qt::KeyboardModifiers();
}

void ChartInteractionTest::movesWithShiftAndTheMiddleButton() {
  QFETCH(Qt::MouseButton, button);
  QFETCH(Qt::KeyboardModifiers, modifiers);
  ShownChart chart;
  chart.setRuns(m_runs);
  turnWheel(chart, chart.plotArea().center(), 4);
  chart.grab();
  const QRectF before = chart.shown();
  const QPoint from = chart.plotArea().center().toPoint();
  drag(chart, from, from + QPoint(50, 20), button, modifiers);
  const QRectF after = chart.shown();
  QVERIFY(isNear(after.width(), before.width(), 1e-9));
  QVERIFY(isNear(after.height(), before.height(), 1e-9));
  QVERIFY(after.left() < before.left());  // what was left of the plot has come in
  QVERIFY(after.top() > before.top());
}

void ChartInteractionTest::resets_data() {
  QTest::addColumn<int>("key");
  QTest::newRow("double click") << 0;
  QTest::newRow("0") << int(Qt::Key_0);
  QTest::newRow("escape") << int(Qt::Key_Escape);
}

void ChartInteractionTest::resets() {
  QFETCH(int, key);
  ShownChart chart;
  chart.setRuns(m_runs);
  const QRectF all = chart.shown();
  turnWheel(chart, chart.plotArea().center(), 4);
  if (key == 0) {
    QTest::mouseDClick(&chart, Qt::LeftButton, {}, chart.plotArea().center().toPoint());
  } else {
    QTest::keyClick(&chart, static_cast<Qt::Key>(key));
  }
  QVERIFY(!chart.plot().zoom().has_value());
  QCOMPARE(chart.shown(), all);
}

void ChartInteractionTest::zoomsAndMovesByKey() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QRectF all = chart.shown();
  QTest::keyClick(&chart, Qt::Key_Plus);
  QVERIFY(isNear(chart.shown().width(), all.width() / 1.5, 1e-9));
  const QRectF before = chart.shown();
  QTest::keyClick(&chart, Qt::Key_Right, Qt::AltModifier);
  QVERIFY(isNear(chart.shown().left() - before.left(), before.width() / 10, 1e-9));
  QTest::keyClick(&chart, Qt::Key_Up, Qt::AltModifier);
  QVERIFY(isNear(chart.shown().top() - before.top(), before.height() / 10, 1e-9));
  QTest::keyClick(&chart, Qt::Key_Left, Qt::AltModifier);
  QTest::keyClick(&chart, Qt::Key_Down, Qt::AltModifier);
  QVERIFY(isNear(chart.shown().left(), before.left(), 1e-9));
  QTest::keyClick(&chart, Qt::Key_Minus);
  QVERIFY(isNear(chart.shown().width(), all.width(), 1e-9));
}

void ChartInteractionTest::takesItsKeysBeforeTheWindow() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const auto isTaken = [&](int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
    event.ignore();
    QCoreApplication::sendEvent(&chart, &event);
    return event.isAccepted();
  };
  QVERIFY(isTaken(Qt::Key_Plus));
  QVERIFY(isTaken(Qt::Key_Left, Qt::AltModifier));
  QVERIFY(!isTaken(Qt::Key_Left));   // steps back
  QVERIFY(!isTaken(Qt::Key_Space));  // plays
  QVERIFY(!isTaken(Qt::Key_Escape));
  turnWheel(chart, chart.plotArea().center(), 4);
  QVERIFY(isTaken(Qt::Key_Escape));
}

void ChartInteractionTest::picksAMomentByClick() {
  ShownChart chart;
  chart.setRuns(m_runs);
  QSignalSpy picked(&chart, &ChartWidget::timePicked);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf({3, 1}));
  QCOMPARE(picked.size(), 1);
  QVERIFY(isNear(picked[0][0].toDouble(), 3, 0.02));  // a pixel
  QVERIFY(!chart.plot().zoom().has_value());
}

void ChartInteractionTest::dragsTheTimeLine() {
  ShownChart chart;
  chart.setRuns(m_runs);
  chart.showTime(2);
  QSignalSpy picked(&chart, &ChartWidget::timePicked);
  drag(chart, chart.placeOf({2, 1}), chart.placeOf({5, 2}));
  QVERIFY(picked.size() >= 2);  // on the way too
  QVERIFY(isNear(picked.constFirst()[0].toDouble(), 3.5, 0.04));
  QVERIFY(isNear(picked.constLast()[0].toDouble(), 5, 0.02));
  QVERIFY(!chart.plot().zoom().has_value());
  // Never before the start.
  chart.showTime(1);
  drag(chart, chart.placeOf({1, 1}), QPoint(0, chart.placeOf({1, 1}).y()));
  QCOMPARE(picked.constLast()[0].toDouble(), 0.0);
}

void ChartInteractionTest::picksTheNearestMomentOfAPath() {
  RecordedScene scene(1, 10, {{.method = "rk4"}});
  scene.runUntil(0.5);
  const QPointF then(scene.run(0).weight(0).position.x(), scene.run(0).weight(0).position.y());
  scene.runUntil(0.8);
  ShownChart chart;
  chart.show(scene, kPaths, {0});
  QSignalSpy picked(&chart, &ChartWidget::timePicked);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf(then));
  QCOMPARE(picked.size(), 1);
  QVERIFY(isNear(picked[0][0].toDouble(), 0.5, 1.01 / 60));
}

void ChartInteractionTest::hidesCurvesAndRunsByClickInTheLegend() {
  ShownChart chart;
  chart.setRuns(m_runs);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, placeOfEntry(chart, "Potential"));
  QVERIFY(curveNamed(chart, "Potential", 0) == nullptr);
  QVERIFY(curveNamed(chart, "Potential", 1) == nullptr);
  QVERIFY(curveNamed(chart, "Kinetic", 1) != nullptr);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, placeOfEntry(chart, "Euler"));
  QVERIFY(curveNamed(chart, "Kinetic", 1) == nullptr);
  QVERIFY(curveNamed(chart, "Kinetic", 0) != nullptr);
  QTest::mouseClick(&chart, Qt::LeftButton, {}, placeOfEntry(chart, "Potential"));
  QVERIFY(curveNamed(chart, "Potential", 0) != nullptr);
}

void ChartInteractionTest::keepsZoomAndHiddenCurvesWhenTheSceneRestarts() {
  RecordedScene scene(2, 10, {{.method = "rk4"}});
  scene.runUntil(2);
  ShownChart chart;
  chart.show(scene, 0, {});
  turnWheel(chart, chart.plotArea().center(), 4);
  chart.setHidden({{"Kinetic"}, {}});
  const QRectF zoomed = chart.shown();
  chart.show(scene, 0, {});
  QCOMPARE(chart.shown(), zoomed);
  QVERIFY(chart.plot().hidden().names.contains("Kinetic"));

  RecordedScene other(2, 10, {{.method = "rk4"}});
  chart.show(other, 0, {});
  QVERIFY(!chart.plot().zoom().has_value());
  QVERIFY(chart.plot().hidden().names.contains("Kinetic"));
  chart.show(other, kPaths, {0});
  QVERIFY(chart.plot().hidden().names.empty());
}

void ChartInteractionTest::readsOffUnderThePointer() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QImage before = chart.grab().toImage();
  const QPoint place = chart.placeOf({1, 2});
  hover(chart, place);
  const int top = static_cast<int>(chart.plotArea().top());
  const QImage during = chart.grab().toImage();
  // A box with the values beside the pointer, and a line through it.
  QVERIFY(during.copy(place.x() + 18, place.y() + 18, 60, 20) !=
          before.copy(place.x() + 18, place.y() + 18, 60, 20));
  QVERIFY(during.copy(place.x() - 1, top, 3, 30) != before.copy(place.x() - 1, top, 3, 30));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&chart, &leave);
  QCOMPARE(chart.grab().toImage(), before);
}

void ChartInteractionTest::showsTheMomentWithoutReadingTheRecordAnew() {
  ShownChart chart;
  chart.setRuns(m_runs);
  const QImage before = chart.grab().toImage();
  const ui::DrawnCurve* drawn = chart.plot().drawn().data();
  chart.showTime(3);
  const QImage after = chart.grab().toImage();
  QCOMPARE(chart.plot().drawn().data(), drawn);
  const int x = chart.placeOf({3, 1}).x();
  const int y = static_cast<int>(chart.plotArea().top()) + 4;
  QVERIFY(after.pixelColor(x, y) != before.pixelColor(x, y));
  QCOMPARE(after.pixelColor(x + 20, y), before.pixelColor(x + 20, y));
}

void ChartInteractionTest::copiesAPictureForPaper() {
  ShownChart chart;
  chart.setRuns(m_runs);
  QPalette dark;
  dark.setColor(QPalette::Window, Qt::black);
  dark.setColor(QPalette::WindowText, Qt::white);
  chart.setPalette(dark);
  QVERIFY(chart.grab().toImage().pixelColor(2, 2).lightness() < 60);
  QTest::keyClick(&chart, Qt::Key_C, Qt::ControlModifier);
  const QImage copied = QGuiApplication::clipboard()->image();
  QCOMPARE(copied.size(), QSize(1890, 1181));  // 160 mm × 100 mm at 300 dpi
  QCOMPARE(copied.pixelColor(2, 2), QColor(Qt::white));
}

void ChartInteractionTest::copiesATable() {
  ShownChart chart;
  chart.setRuns(m_runs);
  chart.copyData();
  const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
  const QStringList rows = copied->text().split('\n');
  QCOMPARE(rows.size(), 1 + 801 + 1);
  QVERIFY(rows[0].startsWith("Time (s), RK4\tKinetic (J), RK4\t"));
  QCOMPARE(rows[1].split('\t').size(), 2 * 6);
  QVERIFY(copied->data("text/csv").startsWith("\"Time (s), RK4\",\"Kinetic (J), RK4\","));
}

void ChartInteractionTest::asksForItsMenuByMouseAndKey() {
  ShownChart chart;
  chart.setRuns(m_runs);
  QSignalSpy wanted(&chart, &ChartWidget::menuRequested);
  QContextMenuEvent byMouse(QContextMenuEvent::Mouse, QPoint(10, 10), QPoint(110, 110));
  QCoreApplication::sendEvent(&chart, &byMouse);
  QCOMPARE(wanted.constLast()[0].toPoint(), QPoint(110, 110));
  QContextMenuEvent byKey(QContextMenuEvent::Keyboard, QPoint(), QPoint());
  QCoreApplication::sendEvent(&chart, &byKey);
  QCOMPARE(wanted.constLast()[0].toPoint(), chart.mapToGlobal(chart.rect().center()));
}

void ChartInteractionTest::drawsCirclesRound() {
  RecordedScene scene(1, 10, {{.method = "rk4"}});
  scene.runUntil(1);
  ShownChart chart(QSize(900, 300));
  chart.show(scene, kPaths, {0});
  const QRectF range = chart.shown();
  const double stretch =
      (chart.plotArea().width() / range.width()) / (chart.plotArea().height() / range.height());
  QVERIFY2(std::abs(stretch - 1) < 0.05, qPrintable(QString::number(stretch)));
  chart.show(scene, kPhase, {0});
  QVERIFY(!chart.plot().drawn().empty());
}

QTEST_MAIN(ChartInteractionTest)
#include "chart_interaction_test.moc"
