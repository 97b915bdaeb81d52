#include <QTest>

#include "core/methods/method.h"
#include "tests/support/corner_scene.h"

/// Corners of the allowed ranges × methods × steps. All corners: tests/bench/corners_walk.
class ExtremesTest : public QObject {
  Q_OBJECT

 private slots:
  void endsSoundlyAtTheCornersOfTheRanges_data();
  void endsSoundlyAtTheCornersOfTheRanges();
  void endsSoundlyWhereItOnceDidNot();
};

void ExtremesTest::endsSoundlyAtTheCornersOfTheRanges_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<double>("step");
  for (const core::Method& method : core::methods())
    for (const double step : {1e-6, 1.0 / 60, 1.0})
      QTest::addRow("%s at %g s", method.id.data(), step) << QByteArray(method.id.data()) << step;
}

void ExtremesTest::endsSoundlyAtTheCornersOfTheRanges() {
  QFETCH(QByteArray, method);
  QFETCH(double, step);
  const core::Solver solver{.method = method.toStdString(), .step = step, .tolerance = 1e-6};
  // A prime, so that every choice is met with every other. Fewer where that takes half an hour.
  constexpr int kStride = ANGRYCUTS_SLOWNESS > 1 ? 1031 : 131;
  constexpr int kSteps = 10;
  for (int corner = 0; corner < 1 << tests::kCornerChoices; corner += kStride) {
    const std::string fault = tests::faultAtCorner(corner, solver, kSteps);
    QVERIFY2(fault.empty(), qPrintable(QString("corner %1: ").arg(corner) + fault.c_str()));
  }
}

void ExtremesTest::endsSoundlyWhereItOnceDidNot() {
  // A weight of a group that turns often on its rope within a stretch, and meets others.
  QCOMPARE(tests::faultAtCorner(507, {"euler", 1.0 / 60, 1e-6}, 20), std::string());
}

QTEST_APPLESS_MAIN(ExtremesTest)
#include "extremes_test.moc"
