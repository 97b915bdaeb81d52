#include "ui/chart/work_precision_plot.h"

#include <cmath>

#include <QChart>
#include <QChartView>
#include <QImageReader>
#include <QLineSeries>
#include <QScatterSeries>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/ui/chart/sample_measurements.h"
#include "ui/chart/trade_view.h"
#include "ui/chart/work_precision_export.h"

using sample_measurements::twoMethods;
using ui::ErrorAgainst;
using ui::WorkPrecisionPlot;

namespace {

QStringList textsIn(const QString& svgFile) {
  QFile file(svgFile);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QStringList texts;
  QXmlStreamReader reader(&file);
  while (!reader.atEnd()) {
    reader.readNext();
    if (reader.isStartElement() && reader.name() == QStringLiteral("text")) {
      texts.append(reader.readElementText().replace(QChar(QChar::Nbsp), ' ').trimmed());
    }
  }
  return texts;
}

/// A plot in a view of its own, 900 × 600 px.
struct Shown {
  explicit Shown(std::shared_ptr<const core::Measurement> measurement) {
    view.resize(900, 600);
    view.plot()->setMeasurement(std::move(measurement));
    view.show();
  }

  QScatterSeries* marks(int index) {
    QList<QScatterSeries*> found;
    for (QAbstractSeries* series : view.chart()->series()) {
      if (auto* scatter = qobject_cast<QScatterSeries*>(series)) found << scatter;
    }
    return found.value(index);
  }

  ui::TradeView<WorkPrecisionPlot> view;
};

}  // namespace

class WorkPrecisionPlotTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void drawsErrorAgainstCost();
  void drawsErrorAgainstStep();
  void writesTheOrderAtEachLine();
  void drawsGuidesOfSlopeOneAndFour();
  void opensAPointThatIsClicked();
  void showsNothingWithoutAMeasurement();
  void leavesOutErrorsThatAreZero();
  void exportsInEveryKind_data();
  void exportsInEveryKind();

 private:
  QString path(const QString& name) const { return m_folder.filePath(name); }

  QTemporaryDir m_folder;
};

void WorkPrecisionPlotTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
}

void WorkPrecisionPlotTest::drawsErrorAgainstCost() {
  Shown shown(twoMethods());
  const QList<QPointF> rungeKutta = shown.marks(1)->points();
  QCOMPARE(rungeKutta.size(), 8);
  // At 1/8 s: 8 µs a second, error 0.5 / 8⁴ m.
  QVERIFY(std::abs(rungeKutta[0].x() - std::log10(8e-6)) < 1e-12);
  QVERIFY(std::abs(rungeKutta[0].y() - std::log10(0.5 / 4096)) < 1e-12);
}

void WorkPrecisionPlotTest::drawsErrorAgainstStep() {
  Shown shown(twoMethods());
  shown.view.plot()->setAgainst(ErrorAgainst::kStep);
  const QList<QPointF> euler = shown.marks(0)->points();
  QVERIFY(std::abs(euler[3].x() - std::log10(1.0 / 64)) < 1e-12);
  QVERIFY(std::abs(euler[3].y() - std::log10(2.0 / 64)) < 1e-12);
}

void WorkPrecisionPlotTest::writesTheOrderAtEachLine() {
  QCOMPARE(ui::writeWorkPrecisionChart(path("cost.svg"), twoMethods(), ErrorAgainst::kCost,
                                       "Two methods"),
           QString());
  const QStringList texts = textsIn(path("cost.svg"));
  for (const char* text : {"Two methods", "Measured over 10 s.", "Euler (explicit): order 1.0",
                           "Runge–Kutta 4: order 4.0", "Computing time per simulated second",
                           "Largest position error", "1 ms", "1 µm"}) {
    QVERIFY2(texts.contains(QString::fromUtf8(text)), qPrintable(texts.join('|')));
  }
}

void WorkPrecisionPlotTest::drawsGuidesOfSlopeOneAndFour() {
  Shown shown(twoMethods());
  shown.view.plot()->setAgainst(ErrorAgainst::kStep);
  QList<double> slopes;
  for (QAbstractSeries* series : shown.view.chart()->series()) {
    auto* line = qobject_cast<QLineSeries*>(series);
    if (line == nullptr || line->pen().style() != Qt::DashLine) continue;
    const QPointF way = line->at(1) - line->at(0);
    slopes << way.y() / way.x();
  }
  QCOMPARE(slopes.size(), 2);
  QVERIFY(std::abs(slopes[0] - 1) < 1e-9);
  QVERIFY(std::abs(slopes[1] - 4) < 1e-9);
  QCOMPARE(ui::writeWorkPrecisionChart(path("step.svg"), twoMethods(), ErrorAgainst::kStep, "S"),
           QString());
  const QStringList texts = textsIn(path("step.svg"));
  for (const char* text : {"slope 1", "slope 4", "Step", "1/64 s"}) {
    QVERIFY2(texts.contains(QString::fromUtf8(text)), qPrintable(texts.join('|')));
  }
}

void WorkPrecisionPlotTest::opensAPointThatIsClicked() {
  Shown shown(twoMethods());
  QVERIFY(QTest::qWaitForWindowExposed(&shown.view));
  QList<core::Solver> picked;
  connect(shown.view.plot(), &WorkPrecisionPlot::pointPicked, this,
          [&](const core::Solver& solver) { picked << solver; });
  QScatterSeries* marks = shown.marks(1);
  const QPointF place = shown.view.chart()->mapToPosition(marks->at(2), marks);
  QTest::mouseClick(shown.view.viewport(), Qt::LeftButton, {},
                    shown.view.mapFromScene(shown.view.chart()->mapToScene(place)));
  QCOMPARE(picked.size(), 1);
  QCOMPARE(picked[0].method, std::string("rk4"));
  QCOMPARE(picked[0].step, 1.0 / 32);
}

void WorkPrecisionPlotTest::showsNothingWithoutAMeasurement() {
  Shown shown(twoMethods());
  shown.view.plot()->setMeasurement(nullptr);
  QVERIFY(shown.view.chart()->series().isEmpty());
  shown.view.plot()->setAgainst(ErrorAgainst::kStep);
  QVERIFY(shown.view.chart()->series().isEmpty());
}

void WorkPrecisionPlotTest::leavesOutErrorsThatAreZero() {
  core::Measurement measurement = *twoMethods();
  for (core::MeasuredPoint& point : measurement.curves[0].points) point.maxPositionError = 0;
  measurement.curves[1].points[0].maxPositionError = 0;
  Shown shown(std::make_shared<const core::Measurement>(measurement));
  QCOMPARE(shown.marks(0)->points().size(), 7);
  QVERIFY(!shown.marks(1));
}

void WorkPrecisionPlotTest::exportsInEveryKind_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("start");
  QTest::newRow("PNG") << "chart.png" << QByteArray("\x89PNG");
  QTest::newRow("SVG") << "chart.svg" << QByteArray("<?xml");
  QTest::newRow("PDF") << "chart.pdf" << QByteArray("%PDF");
}

void WorkPrecisionPlotTest::exportsInEveryKind() {
  QFETCH(QString, name);
  QFETCH(QByteArray, start);
  QCOMPARE(ui::writeWorkPrecisionChart(path(name), twoMethods(), ErrorAgainst::kCost, "Title"),
           QString());
  QFile file(path(name));
  QVERIFY(file.open(QIODevice::ReadOnly));
  QVERIFY(file.readAll().startsWith(start));
}

QTEST_MAIN(WorkPrecisionPlotTest)
#include "work_precision_plot_test.moc"
