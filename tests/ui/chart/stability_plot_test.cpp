#include "ui/chart/stability_plot.h"

#include <QChart>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include "ui/chart/stability_grade.h"
#include "ui/chart/trade_view.h"

using core::Boundedness;
using core::BoundednessTrial;
using ui::StabilityGrade;

namespace {

/// Steps 1/4, 1/2, 1 s and lengths 1, 2 m; from top left: exact, poor, runaway; below: nothing,
/// fair, diverged.
std::shared_ptr<const core::StabilityMap> smallMap(
    core::MapQuantity quantity = core::MapQuantity::kRopeLength) {
  core::StabilityMap map{core::findMethod("euler"), quantity, 10, {0.25, 0.5, 1}, {1, 2}, {}};
  map.cells = {std::nullopt,
               BoundednessTrial{Boundedness::kBounded, 0.05},
               BoundednessTrial{Boundedness::kDiverged, 7},
               BoundednessTrial{Boundedness::kBounded, 0.001},
               BoundednessTrial{Boundedness::kBounded, 0.5},
               BoundednessTrial{Boundedness::kRunaway, 1.5}};
  return std::make_shared<const core::StabilityMap>(std::move(map));
}

}  // namespace

class StabilityPlotTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void gradesByOutcomeAndDrift_data();
  void gradesByOutcomeAndDrift();
  void paintsEachCellInItsColor_data();
  void paintsEachCellInItsColor();
  void worseIsDarker();
  void exportsInEveryKind();
};

void StabilityPlotTest::gradesByOutcomeAndDrift_data() {
  QTest::addColumn<Boundedness>("outcome");
  QTest::addColumn<double>("drift");
  QTest::addColumn<StabilityGrade>("grade");
  QTest::newRow("exact") << Boundedness::kBounded << 0.0099 << StabilityGrade::kExact;
  QTest::newRow("fair") << Boundedness::kBounded << 0.01 << StabilityGrade::kFair;
  QTest::newRow("poor") << Boundedness::kBounded << 0.1 << StabilityGrade::kPoor;
  QTest::newRow("runaway") << Boundedness::kRunaway << 1.1 << StabilityGrade::kRunaway;
  QTest::newRow("diverged") << Boundedness::kDiverged << 0.001 << StabilityGrade::kDiverged;
}

void StabilityPlotTest::gradesByOutcomeAndDrift() {
  QFETCH(Boundedness, outcome);
  QFETCH(double, drift);
  QFETCH(StabilityGrade, grade);
  QCOMPARE(ui::gradeOf({outcome, drift}), grade);
}

void StabilityPlotTest::paintsEachCellInItsColor_data() {
  QTest::addColumn<core::MapQuantity>("quantity");
  QTest::newRow("rope length") << core::MapQuantity::kRopeLength;
  QTest::newRow("air density") << core::MapQuantity::kAirDensity;
}

void StabilityPlotTest::paintsEachCellInItsColor() {
  QFETCH(core::MapQuantity, quantity);
  ui::TradeView<ui::StabilityPlot> view;
  view.resize(900, 600);
  view.plot()->setMap(smallMap(quantity));
  view.show();
  QVERIFY(QTest::qWaitForWindowExposed(&view));
  const QImage image = view.grab().toImage();
  const QRectF plot = view.chart()->plotArea();
  // Off the middle of each cell, where a grid line runs.
  const auto colorAt = [&](int step, int value) {
    const QPointF place(plot.left() + plot.width() * (step + 0.3) / 3,
                        plot.bottom() - plot.height() * (value + 0.3) / 2);
    return image.pixelColor(view.mapFromScene(view.chart()->mapToScene(place)));
  };
  QCOMPARE(colorAt(0, 1), ui::colorOf(StabilityGrade::kExact));
  QCOMPARE(colorAt(1, 1), ui::colorOf(StabilityGrade::kPoor));
  QCOMPARE(colorAt(2, 1), ui::colorOf(StabilityGrade::kRunaway));
  QCOMPARE(colorAt(0, 0), ui::Theme::of(view.palette()).room);
  QCOMPARE(colorAt(1, 0), ui::colorOf(StabilityGrade::kFair));
  QCOMPARE(colorAt(2, 0), ui::colorOf(StabilityGrade::kDiverged));
}

void StabilityPlotTest::worseIsDarker() {
  int lightest = 256;
  for (const StabilityGrade grade : ui::kStabilityGrades) {
    const int gray = qGray(ui::colorOf(grade).rgb());
    QVERIFY(gray < lightest);
    lightest = gray;
  }
}

void StabilityPlotTest::exportsInEveryKind() {
  const QTemporaryDir folder;
  for (const char* name : {"map.png", "map.svg", "map.pdf"}) {
    QCOMPARE(ui::writeStabilityChart(folder.filePath(name), smallMap(), "Title"), QString());
  }
  const QImage image(folder.filePath("map.png"));
  QCOMPARE(image.width(), 2362);  // 200 mm at 300 dpi
  for (const StabilityGrade grade : ui::kStabilityGrades) {
    bool found = false;
    for (int y = image.height() / 3; y < image.height() && !found; y += 7) {
      for (int x = 0; x < image.width() && !found; x += 7) {
        found = image.pixelColor(x, y) == ui::colorOf(grade);
      }
    }
    QVERIFY(found);
  }
}

QTEST_MAIN(StabilityPlotTest)
#include "stability_plot_test.moc"
