#include "ui/panels/trade_window.h"

#include <QAction>
#include <QChart>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScatterSeries>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/file_content.h"
#include "tests/support/settle.h"
#include "ui/chart/trade_view.h"
#include "ui/chart/work_precision_plot.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/translations.h"
#include "ui/main_window.h"
#include "ui/panels/accuracy_panel.h"
#include "ui/panels/measurement_table.h"
#include "ui/panels/stability_panel.h"

using tests::contentOf;
using ui::MainWindow;
using ui::TradeWindow;

namespace {

constexpr int kPatience = 60000;  // [ms] for a measurement on a busy machine

core::Scene swing() {
  core::Scene scene;
  scene.name = "A swing";
  scene.airDensity = 0;
  scene.weights.resize(1);
  scene.weights[0].rope = core::Rope{.pivot = {2, 2.5}, .length = 1, .angle = 1};
  scene.solvers = {{.method = "rk4"}, {.method = "euler"}};
  return scene;
}

/// The real window with the trade window opened by its key.
struct Opened {
  Opened() : window(swing()) {
    window.show();
    window.commands().action(ui::Command::kMeasure)->trigger();
    trade = window.findChild<TradeWindow*>("trade");
  }

  QPushButton* button(QWidget* panel) const { return panel->findChild<QPushButton*>(); }
  QString textIn(QWidget* panel) const {
    QString all;
    for (const QLabel* label : panel->findChildren<QLabel*>()) all += label->text() + '\n';
    return all;
  }

  MainWindow window;
  TradeWindow* trade = nullptr;
};

}  // namespace

class TradeWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void cleanup();
  void isOpenedFromTheMenuOnceForAll();
  void measuresInTheBackgroundAndSaysWhatItFound();
  void showsFirstColumnsWholeInEveryLanguage();
  void aRowOpensAsARun();
  void aPointOpensAsARun();
  void takesThePlaceOfTheLastRunWhereNoMoreFit();
  void anAdaptiveMethodOpensWithItsTolerance();
  void exportsChartAndTable();
  void canBeCancelled();
  void forgetsAMeasurementOfAnotherScene();
  void mapsStability();
  void offersRopeLengthsOnlyWhereThereAreRopes();

 private:
  QTemporaryDir m_folder;
};

void TradeWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void TradeWindowTest::cleanup() {
  QSettings("angrycuts", "angrycuts").clear();
  ui::speak(ui::Language::kEnglish);
}

void TradeWindowTest::isOpenedFromTheMenuOnceForAll() {
  Opened opened;
  QVERIFY(opened.trade && opened.trade->isVisible());
  opened.trade->close();
  opened.window.commands().action(ui::Command::kMeasure)->trigger();
  QCOMPARE(opened.window.findChildren<TradeWindow*>().size(), 1);
  QVERIFY(opened.trade->isVisible());
}

void TradeWindowTest::measuresInTheBackgroundAndSaysWhatItFound() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  auto* progress = panel->findChild<QProgressBar*>();
  QVERIFY(!progress->isVisible());
  QTest::mouseClick(opened.button(panel), Qt::LeftButton);
  QCOMPARE(opened.button(panel)->text(), QString("Cancel"));
  QVERIFY(progress->isVisible());
  QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
  QVERIFY(!progress->isVisible());
  QCOMPARE(opened.button(panel)->text(), QString("Measure"));
  QCOMPARE(panel->measurement()->until, 10.0);
  QVERIFY(
      opened.textIn(panel).contains("To be right within 1\u00a0mm over 10 s: Euler (explicit)"));
  std::size_t points = 0;
  for (const auto& curve : panel->measurement()->curves) points += curve.points.size();
  QCOMPARE(panel->findChild<ui::MeasurementTable*>()->rowCount(), static_cast<int>(points));
}

void TradeWindowTest::showsFirstColumnsWholeInEveryLanguage() {
  Opened opened;
  for (int language = 1; language < ui::kLanguageCount; ++language) {
    opened.window.speak(static_cast<ui::Language>(language));
    auto* trade = opened.window.findChild<TradeWindow*>("trade");
    trade->resize(1216, 686);  // as on 1280 × 720
    ui::AccuracyPanel* panel = trade->accuracy();
    panel->measure(0.5);
    QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
    tests::settle();
    const auto* table = panel->findChild<ui::MeasurementTable*>();
    const int end = table->columnViewportPosition(4) + table->columnWidth(4);
    QVERIFY2(end <= table->viewport()->width(), qPrintable(table->horizontalHeaderItem(4)->text()));
    QVERIFY(table->width() < trade->width() / 2);
  }
}

void TradeWindowTest::aRowOpensAsARun() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  panel->measure(1);
  QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
  auto* table = panel->findChild<ui::MeasurementTable*>();
  QVERIFY(table->item(1, 0)->text().startsWith("Euler"));
  QCOMPARE(table->item(1, 1)->text(), QString("1/16 s"));
  emit table->cellActivated(1, 0);
  QCOMPARE(opened.window.controller()->runCount(), 3);
  QCOMPARE(opened.window.controller()->run(2).solver().method, std::string("euler"));
  QCOMPARE(opened.window.controller()->run(2).solver().step, 1.0 / 16);
  QVERIFY(opened.textIn(opened.trade).contains("is run 3 now"));
  // The measurement is still that of this scene.
  QVERIFY(panel->measurement());
  emit table->cellActivated(1, 0);
  QCOMPARE(opened.window.controller()->runCount(), 3);
}

void TradeWindowTest::aPointOpensAsARun() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  panel->measure(1);
  QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
  auto* view = panel->findChild<QChartView*>();
  QScatterSeries* marks = nullptr;
  for (QAbstractSeries* series : view->chart()->series()) {
    if (!marks) marks = qobject_cast<QScatterSeries*>(series);
  }
  QTRY_VERIFY(view->chart()->plotArea().width() > 100);
  const QPointF place = view->chart()->mapToPosition(marks->at(8), marks);
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                    view->mapFromScene(view->chart()->mapToScene(place)));
  QCOMPARE(opened.window.controller()->runCount(), 3);
  QCOMPARE(opened.window.controller()->run(2).solver().step, 1.0 / 2048);
}

void TradeWindowTest::takesThePlaceOfTheLastRunWhereNoMoreFit() {
  Opened opened;
  for (const double step : {0.1, 0.2, 0.3}) {
    emit opened.trade->accuracy()->picked({.method = "rk4", .step = step});
  }
  QCOMPARE(opened.window.controller()->runCount(), 4);
  QCOMPARE(opened.window.controller()->run(2).solver().step, 0.1);
  QCOMPARE(opened.window.controller()->run(3).solver().step, 0.3);
}

void TradeWindowTest::anAdaptiveMethodOpensWithItsTolerance() {
  Opened opened;
  const core::Solver measured = core::measuredSolvers().back();
  QVERIFY(core::findMethod(measured.method)->isAdaptive);
  emit opened.trade->accuracy()->picked(measured);
  emit opened.trade->accuracy()->picked(measured);
  QCOMPARE(opened.window.controller()->runCount(), 3);
  const core::Solver& running = opened.window.controller()->run(2).solver();
  QCOMPARE(running.method, measured.method);
  QCOMPARE(running.tolerance, measured.tolerance);
  QCOMPARE(running.step, core::Solver().step);
}

void TradeWindowTest::exportsChartAndTable() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  panel->measure(1);
  QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
  panel->saveTable(m_folder.filePath("table.csv"));
  QVERIFY(contentOf(m_folder.filePath("table.csv")).startsWith("method,setting,steps,"));
  panel->saveChart(m_folder.filePath("chart.svg"));
  QVERIFY(contentOf(m_folder.filePath("chart.svg")).contains("per simulated second"));
  for (QComboBox* box : panel->findChildren<QComboBox*>()) {
    if (box->accessibleName() == "What the chart shows") box->setCurrentIndex(1);
  }
  panel->saveChart(m_folder.filePath("chart.svg"));
  QVERIFY(contentOf(m_folder.filePath("chart.svg")).contains("slope 4"));
}

void TradeWindowTest::canBeCancelled() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  panel->measure(1e5);  // would take hours
  QTest::mouseClick(opened.button(panel), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(opened.button(panel)->text(), QString("Measure"), kPatience);
  QVERIFY(!panel->measurement());
}

void TradeWindowTest::forgetsAMeasurementOfAnotherScene() {
  Opened opened;
  ui::AccuracyPanel* panel = opened.trade->accuracy();
  panel->measure(0.5);
  QTRY_VERIFY_WITH_TIMEOUT(panel->measurement(), kPatience);
  opened.window.files()->openBuiltIn("one-pendulum");
  QVERIFY(!panel->measurement());
  QVERIFY(opened.textIn(panel).contains("Measures every method"));
}

void TradeWindowTest::mapsStability() {
  Opened opened;
  opened.trade->findChild<QTabWidget*>()->setCurrentIndex(1);
  ui::StabilityPanel* panel = opened.trade->stability();
  QTest::mouseClick(opened.button(panel), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(panel->map(), kPatience);
  QCOMPARE(panel->map()->method->id, core::methods().front().id);
  QCOMPARE(panel->map()->quantity, core::MapQuantity::kRopeLength);
  QVERIFY(opened.textIn(panel).contains("Largest step that stays bounded over 10 s"));
  panel->saveMap(m_folder.filePath("map.svg"));
  QVERIFY(contentOf(m_folder.filePath("map.svg")).contains("Length of the longest rope"));
}

void TradeWindowTest::offersRopeLengthsOnlyWhereThereAreRopes() {
  Opened opened;
  QComboBox* quantities = nullptr;
  for (QComboBox* box : opened.trade->stability()->findChildren<QComboBox*>()) {
    if (box->accessibleName() == "What the map changes besides the step") quantities = box;
  }
  QCOMPARE(quantities->count(), 2);
  opened.window.editor()->change([](core::Scene& draft) {
    draft.weights[0].rope.reset();
    draft.weights[0].position = {1, 1};
  });
  QCOMPARE(quantities->count(), 1);
  QCOMPARE(quantities->currentText(), QString("air density"));
}

QTEST_MAIN(TradeWindowTest)
#include "trade_window_test.moc"
