#include <QDockWidget>
#include <QGuiApplication>
#include <QLocale>
#include <QScreen>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>

#include "core/scene/scene.h"
#include "core/trade/reference.h"
#include "tests/support/offscreen_screen.h"
#include "ui/control/run_controller.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"

using ui::MainWindow;

namespace {

constexpr QSize kScreen(1280, 720);  // a projector's
constexpr int kTitleBar = 40;        // px, of the desktop's frame, generously

/// The scene the window opens with, with the first so many runs that the form offers.
core::Scene sceneWith(int runCount) {
  core::Scene scene = ui::builtInScene("seven-weights");
  const core::Solver first = scene.solvers.front();
  scene.solvers = {first, first, first, core::referenceSolver(first.step)};
  scene.solvers[1].method = "euler";
  scene.solvers[2].method = "semi-implicit-euler";
  scene.solvers.resize(static_cast<std::size_t>(runCount));
  return scene;
}

}  // namespace

class WindowSizeTest : public QObject {
  Q_OBJECT

 public:
  static void initMain() { tests::useScreen(kScreen); }

 private slots:
  void initTestCase();
  void fitsOnAProjector_data();
  void fitsOnAProjector();
  void showsAllTabsOfTheChartsOnAProjector();

 private:
  QTemporaryDir m_folder;
};

void WindowSizeTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  QCOMPARE(QGuiApplication::primaryScreen()->size(), kScreen);
}

void WindowSizeTest::fitsOnAProjector_data() {
  QTest::addColumn<int>("runCount");
  QTest::addColumn<QString>("panel");
  for (const int runCount : {2, 4})
    for (const char* panel : {"charts", "comparison", "step", "events"})
      QTest::addRow("%d runs, %s", runCount, panel) << runCount << QString(panel);
}

void WindowSizeTest::fitsOnAProjector() {
  QFETCH(int, runCount);
  QFETCH(QString, panel);
  MainWindow window(sceneWith(runCount));
  window.show();
  window.findChild<QDockWidget*>(panel)->raise();
  window.controller()->stepOnce();
  QCoreApplication::processEvents();
  const QSize least = window.minimumSizeHint();
  const QSize room = kScreen - QSize(0, kTitleBar);
  QVERIFY2(least.boundedTo(room) == least,
           qPrintable(QString("%1 × %2 px").arg(least.width()).arg(least.height())));
}

void WindowSizeTest::showsAllTabsOfTheChartsOnAProjector() {
  MainWindow window(sceneWith(4));
  window.setWindowState(Qt::WindowNoState);
  window.resize(kScreen - QSize(0, kTitleBar));
  window.show();
  auto* charts = window.findChild<ui::ChartsPanel*>();
  auto* tabs = charts->choosers()->findChild<QTabBar*>();
  for (int kind = 0; kind < tabs->count(); ++kind) {
    charts->chooseKind(kind);
    QCoreApplication::processEvents();
    QVERIFY2(tabs->width() >= tabs->sizeHint().width(), qPrintable(tabs->tabText(kind)));
  }
}

QTEST_MAIN(WindowSizeTest)
#include "window_size_test.moc"
