#include "ui/panels/cut_window.h"

#include <algorithm>

#include <QAction>
#include <QChart>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/fields.h"
#include "tests/support/file_content.h"
#include "tests/support/shown_window.h"
#include "ui/chart/cut_sweep_chart.h"
#include "ui/chart/cut_sweep_result.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_target.h"
#include "ui/control/target_control.h"
#include "ui/main_window.h"
#include "ui/panels/cut_results.h"
#include "ui/panels/hit_table.h"
#include "ui/panels/quantity_field.h"
#include "ui/style/theme.h"
#include "ui/view/scene_area.h"

using tests::contentOf;
using ui::CutWindow;

namespace {

constexpr int kPatience = 60000;  // [ms] for a sweep on a busy machine

core::Scene twoSwings() {
  core::Scene scene;
  scene.name = "Two swings";
  scene.airDensity = 0;
  scene.room = {.width = 6, .height = 4};
  scene.weights.resize(2);
  scene.weights[0].rope = core::Rope{.pivot = {3, 2.5}, .length = 1, .angle = 1};
  scene.weights[1].rope = core::Rope{.pivot = {3, 3.9}, .length = 0.4, .angle = -0.5};
  scene.solvers = {{.method = "rk4", .step = 1.0 / 30}, {.method = "euler", .step = 1.0 / 30}};
  return scene;
}

/// The real window with the one that finds moments opened by its key, and its sweep done.
struct Opened {
  Opened() : window(twoSwings()) {
    target()->setPlace({2.2, 0.3});
    window.press(Qt::Key_W);
    cuts = window.findChild<CutWindow*>("whenToCut");
    wait();
  }

  /// Until the hits on the target as it is are found.
  void wait() const {
    const bool isDone = QTest::qWaitFor(
        [this] {
          return cuts->result() && button()->text() == "Find" && !cuts->result()->hits.empty() &&
                 cuts->result()->target == target()->place();
        },
        kPatience);
    if (!isDone) qFatal("no hits were found");
  }

  ui::SceneTarget* target() const { return window.target()->target(); }
  QPushButton* button() const { return cuts->findChild<QPushButton*>(); }
  ui::CutSweepChart* chart() const { return cuts->findChild<ui::CutSweepChart*>(); }
  ui::QuantityField* field(const QString& name) const { return tests::fieldNamed(*cuts, name); }
  void type(const QString& name, const QString& text) const { tests::enter(field(name), text); }
  QPoint pixelOf(double cutTime, double place) const {
    return chart()->plot()->toChart().map(QPointF(cutTime, place)).toPoint();
  }
  QString words() const {
    QString all;
    for (const QLabel* label : cuts->findChildren<QLabel*>()) all += label->text() + '\n';
    return all;
  }

  tests::ShownWindow window;
  CutWindow* cuts = nullptr;
};

}  // namespace

class CutWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void aKeyOpensItAndItFindsTheMoments();
  void aClickOnAHitMakesPlayHitTheTarget();
  void aClickElsewhereCutsThen();
  void thePointerReadsTheCurve();
  void aRowCutsAtItsMoment();
  void theCutCanBeUndone();
  void aMovedTargetIsAimedAtAnew();
  void theTargetCanBeSetInNumbers();
  void anotherWeightIsSweptAnew();
  void anotherMethodIsSweptAnew();
  void anotherSceneIsSweptAnewButNotAnotherCut();
  void aRangeThatEndsBeforeItBeginsIsRefused();
  void saysThatNothingHits();
  void canBeCancelled();
  void exportsChartAndTable();
  void copiesChartAndData();

 private:
  QTemporaryDir m_folder;
};

void CutWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void CutWindowTest::aKeyOpensItAndItFindsTheMoments() {
  Opened opened;
  QVERIFY(opened.cuts->isVisible());
  QVERIFY(opened.target()->isShown());
  const auto& hits = opened.cuts->result()->hits;
  QCOMPARE(opened.cuts->findChild<ui::HitTable*>()->rowCount(), static_cast<int>(hits.size()));
  for (std::size_t i = 1; i < hits.size(); ++i)
    QVERIFY(hits[i].until - hits[i].from <= hits[i - 1].until - hits[i - 1].from);
  QVERIFY(opened.words().contains("Of the cut times from 0 s to 10 s"));
  opened.cuts->close();
  opened.window.commands().action(ui::Command::kWhenToCut)->trigger();
  QCOMPARE(opened.window.findChildren<CutWindow*>().size(), 1);
}

void CutWindowTest::aClickOnAHitMakesPlayHitTheTarget() {
  Opened opened;
  const core::Hit hit = opened.cuts->result()->hits.front();
  opened.window.controller()->goTo(0.3);
  QTest::mouseClick(opened.chart()->viewport(), Qt::LeftButton, {}, opened.pixelOf(hit.best, 2.2));
  QVERIFY(opened.window.editor()->scene()->cutTime == hit.best);
  QCOMPARE(opened.window.controller()->time(), 0.0);
  QVERIFY(!opened.window.controller()->isPlaying());
  QVERIFY(opened.words().contains("now"));
  opened.window.controller()->goTo(hit.landsAt + 0.5);
  const auto* shown = opened.window.findChild<ui::SceneArea*>()->views().front()->target();
  // The run lands where the sweep said, to the last bit; that is the target's center.
  QCOMPARE(shown->landings[0]->time, hit.landsAt);
  QVERIFY(std::abs(shown->landings[0]->place - opened.target()->place().center) < 1e-9);
}

void CutWindowTest::aClickElsewhereCutsThen() {
  Opened opened;
  // Between two hits, further from both than a click reaches.
  std::vector<core::Hit> hits = opened.cuts->result()->hits;
  std::ranges::sort(hits, {}, &core::Hit::from);
  const double between = (hits[0].until + hits[1].from) / 2;
  const QPoint place = opened.pixelOf(between, 3);
  QTest::mouseClick(opened.chart()->viewport(), Qt::LeftButton, {}, place);
  const double pixel = 1 / opened.chart()->plot()->toChart().m11();
  QVERIFY(std::abs(*opened.window.editor()->scene()->cutTime - between) <= pixel);
}

void CutWindowTest::thePointerReadsTheCurve() {
  const Opened opened;
  ui::CutSweepChart* chart = opened.chart();
  const auto drawn = [&] { return chart->viewport()->grab().toImage(); };
  const std::vector<core::Landing>& landings = opened.cuts->result()->landings;
  const auto middle = landings.begin() + static_cast<std::ptrdiff_t>(landings.size() / 2);
  const core::Landing& landing = *std::ranges::find(
      middle, landings.end(), core::LandingOutcome::kLanded, &core::Landing::outcome);
  const QPoint place = opened.pixelOf(landing.cutTime, landing.place);
  const QImage before = drawn();
  QMouseEvent move(QEvent::MouseMove, place, chart->viewport()->mapToGlobal(place), Qt::NoButton,
                   Qt::NoButton, {});
  QCoreApplication::sendEvent(chart->viewport(), &move);
  QCOMPARE(chart->viewport()->cursor().shape(), Qt::PointingHandCursor);
  // A dot on the curve, and words beside it.
  const QImage reading = drawn();
  QCOMPARE(reading.pixelColor(place), ui::Theme::of(chart->palette()).text);
  const QRect beside(place + QPoint(12, -60), QSize(60, 120));
  QVERIFY(reading.copy(beside) != before.copy(beside));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(chart, &leave);
  QCOMPARE(drawn(), before);
}

void CutWindowTest::aRowCutsAtItsMoment() {
  Opened opened;
  auto* table = opened.cuts->findChild<ui::HitTable*>();
  table->setCurrentCell(1, 0);
  QTest::keyClick(table, Qt::Key_Return);
  QVERIFY(opened.window.editor()->scene()->cutTime == opened.cuts->result()->hits[1].best);
}

void CutWindowTest::theCutCanBeUndone() {
  Opened opened;
  emit opened.chart()->momentPicked(1.25);
  QCOMPARE(*opened.window.editor()->scene()->cutTime, 1.25);
  opened.window.editor()->undo();
  QVERIFY(!opened.window.editor()->scene()->cutTime);
}

void CutWindowTest::aMovedTargetIsAimedAtAnew() {
  Opened opened;
  const double before = opened.cuts->result()->hits.front().best;
  opened.target()->setPlace({2.5, 0.3});
  QVERIFY(opened.cuts->result()->hits.empty());  // the old ones hit no more
  QCOMPARE(opened.cuts->result()->target.center, 2.5);
  opened.wait();
  QVERIFY(opened.cuts->result()->hits.front().best != before);
}

void CutWindowTest::theTargetCanBeSetInNumbers() {
  Opened opened;
  opened.type("Center of the target", "2.6");
  opened.type("Width of the target", "0.2");
  QCOMPARE(opened.target()->place(), (core::Target{2.6, 0.2}));
  opened.wait();
}

void CutWindowTest::anotherWeightIsSweptAnew() {
  Opened opened;
  opened.target()->setPlace({3, 0.3});
  opened.wait();
  QTest::keyClick(opened.cuts->findChild<QSpinBox*>(), Qt::Key_Up);
  QCOMPARE(opened.target()->weight(), 1);
  QVERIFY(!opened.cuts->result());
  opened.wait();
  QCOMPARE(opened.cuts->result()->question.weight, 1);
}

void CutWindowTest::anotherMethodIsSweptAnew() {
  Opened opened;
  auto* runs = opened.cuts->findChild<QComboBox*>();
  QCOMPARE(runs->count(), 2);
  runs->setCurrentIndex(1);
  emit runs->activated(1);
  QTRY_COMPARE_WITH_TIMEOUT(opened.cuts->result()->solver.method, std::string("euler"), kPatience);
}

void CutWindowTest::anotherSceneIsSweptAnewButNotAnotherCut() {
  Opened opened;
  const auto result = opened.cuts->result();
  opened.window.editor()->change([](core::Scene& scene) { scene.cutTime = 3; });
  QVERIFY(opened.cuts->result() == result);
  opened.window.editor()->change([](core::Scene& scene) { scene.gravity = 5; });
  QVERIFY(!opened.cuts->result());
  opened.wait();
  QVERIFY(opened.cuts->result()->hits.front().best != result->hits.front().best);
}

void CutWindowTest::aRangeThatEndsBeforeItBeginsIsRefused() {
  Opened opened;
  const auto result = opened.cuts->result();
  opened.type("First cut time", "20");
  QVERIFY(opened.field("Last cut time")->isMarked());
  QVERIFY(opened.cuts->result() == result);
  opened.type("Last cut time", "22");
  QVERIFY(!opened.field("Last cut time")->isMarked());
  QTRY_COMPARE_WITH_TIMEOUT(opened.cuts->result()->question.from, 20.0, kPatience);
}

void CutWindowTest::saysThatNothingHits() {
  Opened opened;
  opened.type("Center of the target", "5.9");
  QTRY_VERIFY_WITH_TIMEOUT(opened.words().contains("No cut makes weight 1 hit the target."),
                           kPatience);
}

void CutWindowTest::canBeCancelled() {
  Opened opened;
  opened.window.editor()->change([](core::Scene& scene) {
    scene.solvers = {{.method = "rk4", .step = 1e-6}};  // would take hours
  });
  QTRY_COMPARE_WITH_TIMEOUT(opened.button()->text(), QString("Cancel"), kPatience);
  QTest::mouseClick(opened.button(), Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(opened.button()->text(), QString("Find"), kPatience);
  QVERIFY(!opened.cuts->result());
}

void CutWindowTest::exportsChartAndTable() {
  Opened opened;
  opened.cuts->results()->saveChart(m_folder.filePath("cut.svg"));
  QVERIFY(contentOf(m_folder.filePath("cut.svg")).contains("Lands at (m)"));
  opened.cuts->results()->saveChart(m_folder.filePath("cut.pdf"));
  QVERIFY(contentOf(m_folder.filePath("cut.pdf")).startsWith("%PDF"));
  opened.cuts->results()->saveChart(m_folder.filePath("cut.png"));
  QVERIFY(QImage(m_folder.filePath("cut.png")).width() > 2000);
  opened.cuts->results()->saveTable(m_folder.filePath("cut.csv"));
  const QList<QByteArray> rows = contentOf(m_folder.filePath("cut.csv")).split('\n');
  QVERIFY(rows.front().startsWith("Cut (s),Lands at (m),"));
  QCOMPARE(static_cast<std::size_t>(rows.size()), opened.cuts->result()->landings.size() + 2);
  const core::Landing& last = opened.cuts->result()->landings.back();
  QCOMPARE(rows[rows.size() - 2].split(',')[1].toDouble(), last.place);
}

void CutWindowTest::copiesChartAndData() {
  Opened opened;
  opened.cuts->results()->copyData();
  const QMimeData* copied = QGuiApplication::clipboard()->mimeData();
  QVERIFY(copied->text().startsWith("Cut (s)\tLands at (m)\t"));
  QVERIFY(copied->data("text/csv").startsWith("Cut (s),"));
  opened.cuts->results()->copyChart();
  QVERIFY(QGuiApplication::clipboard()->image().width() > 2000);
}

QTEST_MAIN(CutWindowTest)
#include "cut_window_test.moc"
