#include <algorithm>
#include <cmath>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFileDialog>
#include <QImageReader>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QSettings>
#include <QSpinBox>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include "core/scene/arrangement.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_widget.h"
#include "ui/chart/curves_item.h"
#include "ui/control/commands.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/control/settings.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/style/theme.h"
#include "ui/view/scene_view.h"

using tests::swingingScene;
using ui::ChartWidget;

namespace {

constexpr int kPhase = 2;
constexpr int kHeight = 4;

/// The window on the screen, with a run of some seconds behind it.
class ChartsWindow : public tests::ShownWindow {
 public:
  explicit ChartsWindow(const core::Scene& scene = swingingScene(), QSize size = tests::kProjector)
      : ShownWindow(scene, size) {}

  void play(double seconds) {
    controller()->play();
    for (int frame = 0; frame < std::lround(seconds * 60); ++frame) {
      controller()->passTime(1.0 / 60);
    }
    controller()->pause();
    // The chart draws when it is its turn.
    if (!QTest::qWaitFor([this] { return !chart().plot().hasNews(); })) qFatal("nothing drawn");
    chart().grab();
  }

  ChartWidget& chart() const { return *charts()->chart(); }
  QTabBar& kinds() const { return *charts()->choosers()->findChild<QTabBar*>(); }
  QSpinBox& weight() const { return *charts()->choosers()->findChild<QSpinBox*>(); }
  QAction& action(ui::Command command) const { return *commands().action(command); }

  QPoint placeOf(QPointF values) const {
    return ui::plotTransform(chart().plot().range(), chart().plotArea()).map(values).toPoint();
  }
};

void moveWithLeftButton(ChartWidget& chart, QPoint place) {
  QMouseEvent move(QEvent::MouseMove, place, chart.mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QCoreApplication::sendEvent(&chart, &move);
}

QDialog* dialogInFront() {
  return qobject_cast<QDialog*>(QApplication::activeModalWidget());
}

}  // namespace

/// Charts in the real window, by keys, mouse, clipboard and files.
class ChartsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init() { QSettings("angrycuts", "angrycuts").clear(); }
  void offersEveryKindByTabAndKey();
  void tabsTakeArrowsOnlyWhileTheyHaveTheFocus();
  void followsTheRun();
  void draggingTheTimeLineGoesBackEverywhere();
  void pickingOnAPathGoesThere();
  void choosesAWeightByKey();
  void followsAWeightAmongManyOnceItIsChosen();
  void choosesRuns();
  void zoomsByWheelAndResetsByKey();
  void copiesPictureAndDataByKey();
  void hidesCurvesFromTheMenu();
  void exportsWhatIsShownAtTheChosenSize();
  void asksForTheSize();
  void exportsNothingWhenTheSizeIsCancelled();
  void staysLightOnPaperInADarkWindow();
  void givesTheSceneMostOfTheHeight();
  void remembersTheSplitter();

 private:
  QTemporaryDir m_folder;
};

void ChartsWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void ChartsWindowTest::offersEveryKindByTabAndKey() {
  ChartsWindow window;
  window.play(0.5);
  QCOMPARE(window.kinds().count(), static_cast<int>(ui::chartKinds().size()));
  for (const ui::ChartKind& kind : ui::chartKinds()) {
    QCOMPARE(&window.chart().plot().kind(), &kind);
    QCOMPARE(window.chart().accessibleName(), kind.tip());
    QVERIFY(!window.chart().plot().drawn().empty());
    QVERIFY(!window.chart().grab().isNull());
    QTest::keyClick(&window, Qt::Key_PageDown, Qt::ControlModifier);
  }
  QCOMPARE(&window.chart().plot().kind(), &ui::chartKinds().front());  // round again
  QTest::keyClick(&window, Qt::Key_PageUp, Qt::ControlModifier);
  QCOMPARE(&window.chart().plot().kind(), &ui::chartKinds().back());
  QTest::mouseClick(&window.kinds(), Qt::LeftButton, {}, window.kinds().tabRect(1).center());
  QCOMPARE(window.chart().plot().kind().id, "ledger");
}

void ChartsWindowTest::tabsTakeArrowsOnlyWhileTheyHaveTheFocus() {
  ChartsWindow window;
  QTest::keyClick(&window, Qt::Key_Right);
  QVERIFY(window.controller()->time() > 0);  // stepped
  const double before = window.controller()->time();
  window.kinds().setFocus();
  QTest::keyClick(&window.kinds(), Qt::Key_Right);
  QCOMPARE(window.kinds().currentIndex(), 1);
  QCOMPARE(window.controller()->time(), before);
}

void ChartsWindowTest::followsTheRun() {
  ChartsWindow window;
  window.play(1);
  QTRY_COMPARE(window.chart().plot().caches()[0].points().back().time,
               window.controller()->run(0).time());
}

void ChartsWindowTest::draggingTheTimeLineGoesBackEverywhere() {
  ChartsWindow window;
  window.play(2);
  const core::WeightState end = window.controller()->run(0).weight(1);
  QTest::mousePress(&window.chart(), Qt::LeftButton, {}, window.placeOf({2, 0.1}));
  moveWithLeftButton(window.chart(), window.placeOf({1, 0.1}));
  QVERIFY(std::abs(window.controller()->time() - 1) < 0.02);  // two pixels
  QVERIFY(window.controller()->run(0).time() < 1.1);
  QVERIFY(window.controller()->run(0).weight(1).position != end.position);
  QTest::mouseRelease(&window.chart(), Qt::LeftButton, {}, window.placeOf({1, 0.1}));
  // What was recorded is still there, and the chart still shows it.
  QCOMPARE(window.chart().plot().caches()[0].points().back().time,
           window.controller()->recordedUntil());
}

void ChartsWindowTest::pickingOnAPathGoesThere() {
  ChartsWindow window;
  window.play(0.7);
  window.charts()->chooseKind(kPhase);
  window.chart().grab();
  const auto points = window.chart().plot().caches()[1].points();
  const core::TimedPoint then = points[20];
  QTest::mouseClick(&window.chart(), Qt::LeftButton, {}, window.placeOf({then.x, then.y}));
  QVERIFY(std::abs(window.controller()->time() - then.time) < 0.05);
}

void ChartsWindowTest::choosesAWeightByKey() {
  ChartsWindow window;
  window.play(0.5);
  QVERIFY(!window.weight().isVisible());  // energies are of all
  window.charts()->chooseKind(kHeight);
  QVERIFY(window.weight().isVisible());
  QCOMPARE(window.chart().plot().content().curves.size(), std::size_t{6});
  window.weight().setFocus();
  QTest::keyClick(&window.weight(), Qt::Key_Up);
  QTest::keyClick(&window.weight(), Qt::Key_Up);
  QCOMPARE(window.chart().plot().content().curves.size(), std::size_t{2});
  QCOMPARE(window.chart().plot().content().curves[0].name, QString("Weight 2"));
}

void ChartsWindowTest::followsAWeightAmongManyOnceItIsChosen() {
  ChartsWindow window(swingingScene(30));
  window.play(0.5);
  window.charts()->chooseKind(kHeight);
  QCOMPARE(window.chart().plot().content().note, QString("The first 24 of 30 weights"));
  window.charts()->chooseWeight(28);
  window.play(0.5);
  const auto points = window.chart().plot().caches()[0].points();
  QCOMPARE(points.front().time, 0.0);
  QTRY_COMPARE(window.chart().plot().caches()[0].points().back().y,
               window.controller()->run(0).weight(28).position.y());
}

void ChartsWindowTest::choosesRuns() {
  ChartsWindow window;
  auto* runs = window.charts()->choosers()->findChild<QComboBox*>();
  QCOMPARE(runs->count(), 3);
  QCOMPARE(window.chart().plot().subject().runs.size(), std::size_t{2});
  runs->setFocus();
  QTest::keyClick(runs, Qt::Key_Down);
  QTest::keyClick(runs, Qt::Key_Down);
  QCOMPARE(window.chart().plot().subject().runs.size(), std::size_t{1});
  QCOMPARE(window.chart().plot().subject().runs[0].ledger,
           &window.controller()->recording(1).ledger());
}

void ChartsWindowTest::zoomsByWheelAndResetsByKey() {
  ChartsWindow window;
  window.play(1);
  const QPointF place = window.chart().plotArea().center();
  QWheelEvent turn(place, window.chart().mapToGlobal(place), QPoint(), QPoint(0, 360), Qt::NoButton,
                   Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window.chart(), &turn);
  QVERIFY(window.chart().plot().zoom().has_value());
  window.play(0.2);
  QVERIFY(window.chart().plot().zoom().has_value());  // stays while the run goes on
  QTest::keyClick(&window, Qt::Key_0, Qt::ControlModifier);
  QVERIFY(!window.chart().plot().zoom().has_value());
}

void ChartsWindowTest::copiesPictureAndDataByKey() {
  ChartsWindow window;
  window.play(0.5);
  window.controller()->stepOnce();  // which the chart has had no time to draw
  QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(QGuiApplication::clipboard()->image().size(), QSize(1890, 1181));
  QTest::keyClick(&window, Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  const QString table = QGuiApplication::clipboard()->text();
  const QStringList rows = table.split('\n', Qt::SkipEmptyParts);
  QCOMPARE(rows.size(), 1 + 32);
  const core::EnergySample last = window.controller()->recording(0).ledger().samples().back();
  QCOMPARE(rows.last().split('\t')[0].toDouble(), last.time);
  QCOMPARE(rows.last().split('\t')[1].toDouble(), last.energies.kinetic);
}

void ChartsWindowTest::hidesCurvesFromTheMenu() {
  ChartsWindow window;
  window.play(0.5);
  auto* menu = window.charts()->findChild<QMenu*>();
  emit menu->aboutToShow();
  QAction* potential = nullptr;
  for (QAction* action : window.charts()->findChildren<QAction*>()) {
    if (action->text() == "Potential") potential = action;
  }
  QVERIFY(potential && potential->isChecked());
  const auto drawn = window.chart().plot().drawn().size();
  potential->trigger();
  QCOMPARE(window.chart().plot().drawn().size(), drawn - 2);  // of both runs
  QVERIFY(window.chart().plot().hidden().names.contains("Potential"));
}

void ChartsWindowTest::exportsWhatIsShownAtTheChosenSize() {
  ChartsWindow window;
  window.play(1);
  window.charts()->chooseKind(kHeight);
  const QString all = m_folder.filePath("all.svg");
  const QString one = m_folder.filePath("one.svg");
  window.exports()->saveChart(all, QSizeF(254, 143));
  window.charts()->chooseWeight(1);
  window.exports()->saveChart(one, QSizeF(254, 143));
  for (const QString& name : {all, one}) {
    QFile file(name);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    QVERIFY(svg.contains("Height (m)"));
    QCOMPARE(svg.contains("Weight 3"), name == all);
    // To the pixel: 150 to the inch.
    const double width = 25.4 / 150 * std::round(254 / 25.4 * 150);
    QVERIFY(svg.contains(QByteArray("width=\"") + QByteArray::number(width) + "mm\""));
  }
}

void ChartsWindowTest::asksForTheSize() {
  ChartsWindow window;
  window.play(0.5);
  QTimer::singleShot(0, this, [this] {
    QDialog* size = dialogInFront();
    QVERIFY(size);
    const QList<QSpinBox*> fields = size->findChildren<QSpinBox*>();
    QCOMPARE(fields.size(), 2);
    QCOMPARE(fields[0]->value(), 160);
    size->findChild<QComboBox*>()->setFocus();
    QTest::keyClick(size->findChild<QComboBox*>(), Qt::Key_Down);  // half the page width
    QCOMPARE(fields[0]->value(), 80);
    fields[1]->setValue(70);
    QTimer::singleShot(0, this, [this] {
      auto* file = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      QVERIFY(file);
      file->setDirectory(m_folder.path());
      file->findChild<QLineEdit*>()->setText("sized");
      QTest::keyClick(file->findChild<QLineEdit*>(), Qt::Key_Return);
    });
    size->accept();
  });
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
  const QSize size = QImageReader(m_folder.filePath("sized.png")).size();
  QVERIFY(std::abs(size.width() - 80 / 25.4 * 300) <= 1);
  QVERIFY(std::abs(size.height() - 70 / 25.4 * 300) <= 1);
  QCOMPARE(ui::Settings().chartSize(), QSizeF(80, 70));
}

void ChartsWindowTest::exportsNothingWhenTheSizeIsCancelled() {
  ChartsWindow window;
  bool asked = false;
  QTimer::singleShot(0, this, [&asked] {
    asked = dialogInFront() != nullptr;
    dialogInFront()->reject();
  });
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
  QVERIFY(asked);
  QVERIFY(dialogInFront() == nullptr);
}

void ChartsWindowTest::staysLightOnPaperInADarkWindow() {
  ChartsWindow window;
  window.play(0.5);
  for (QAction* action : window.findChildren<QAction*>()) {
    if (action->text().remove('&') == "Dark") action->trigger();
  }
  QTRY_VERIFY(ui::Theme::of(window.chart().palette()).dark);
  QVERIFY(window.chart().grab().toImage().pixelColor(1, 1).lightness() < 60);
  const QString file = m_folder.filePath("light.png");
  window.exports()->saveChart(file);
  QCOMPARE(QImage(file).pixelColor(2, 2), QColor(Qt::white));
  QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(QGuiApplication::clipboard()->image().pixelColor(2, 2), QColor(Qt::white));
}

void ChartsWindowTest::givesTheSceneMostOfTheHeight() {
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
    ChartsWindow window(swingingScene(), size);
    const auto* dock = window.findChild<QDockWidget*>("charts");
    const double scene = window.findChild<ui::SceneView*>()->height();
    const double share = scene / (scene + dock->height());
    QVERIFY2(share > 0.55 && share < 0.65, qPrintable(QString::number(share)));
  }
}

void ChartsWindowTest::remembersTheSplitter() {
  int height = 0;
  {
    ChartsWindow window(swingingScene(), QSize(1600, 1000));
    auto* dock = window.findChild<QDockWidget*>("charts");
    const int before = dock->height();
    window.resizeDocks({dock}, {before + 100}, Qt::Vertical);
    QTRY_VERIFY(dock->height() > before + 30);
    height = dock->height();
    window.close();
  }
  ChartsWindow window(swingingScene(), QSize(1600, 1000));
  QCOMPARE(window.findChild<QDockWidget*>("charts")->height(), height);
}

QTEST_MAIN(ChartsWindowTest)
#include "charts_window_test.moc"
