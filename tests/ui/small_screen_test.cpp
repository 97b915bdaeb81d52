// A screen of 1920 × 1080 pixels, each thing twice as large: 960 × 540 for the window.
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QScreen>
#include <QScrollBar>
#include <QSettings>
#include <QSlider>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/support/offscreen_screen.h"
#include "tests/support/settle.h"
#include "ui/chart/chart_widget.h"
#include "ui/control/run_controller.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/form_area.h"
#include "ui/panels/playback_bar.h"
#include "ui/view/scene_area.h"

using ui::MainWindow;

namespace {

constexpr QSize kScreen(960, 540);
constexpr int kTitleBar = 24;  // px, of the desktop's frame

QString describe(QSize size) {
  return QString("%1 × %2 px").arg(size.width()).arg(size.height());
}

}  // namespace

class SmallScreenTest : public QObject {
  Q_OBJECT

 public:
  static void initMain();

 private slots:
  void initTestCase();
  void fitsTheScreen_data();
  void fitsTheScreen();
  void cutsNothingOff();
  void namesCurvesBesideTheEnergies();
  void saysInPlaceOfTheSpeedHowSlowItIs();

 private:
  QTemporaryDir m_folder;
};

void SmallScreenTest::initMain() {
  tests::useScreen(kScreen);
}

void SmallScreenTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  QCOMPARE(QGuiApplication::primaryScreen()->size(), kScreen);
}

void SmallScreenTest::fitsTheScreen_data() {
  QTest::addColumn<QString>("panel");
  for (const char* panel : {"charts", "comparison", "step", "weightsTable", "events"})
    QTest::newRow(panel) << QString(panel);
}

void SmallScreenTest::fitsTheScreen() {
  QFETCH(QString, panel);
  MainWindow window(ui::builtInScene("seven-weights"));
  window.show();
  window.findChild<QDockWidget*>(panel)->raise();
  window.controller()->stepOnce();
  tests::settle();
  const QSize least = window.minimumSizeHint();
  const QSize room = kScreen - QSize(0, kTitleBar);
  QVERIFY2(least.boundedTo(room) == least, qPrintable(describe(least)));
}

void SmallScreenTest::cutsNothingOff() {
  MainWindow window(ui::builtInScene("seven-weights"));
  window.setWindowState(Qt::WindowNoState);
  window.resize(kScreen - QSize(0, kTitleBar));
  window.show();
  tests::settle();
  QCOMPARE(window.size(), kScreen - QSize(0, kTitleBar));
  for (const ui::FormArea* form : window.findChildren<ui::FormArea*>())
    if (form->isVisible()) QVERIFY(form->viewport()->width() >= form->widget()->width());
  const auto* bar = window.findChild<ui::PlaybackBar*>();
  for (const QWidget* part : bar->findChildren<QWidget*>()) {
    if (!part->isVisible()) continue;
    const QRect place(part->mapTo(bar, QPoint(0, 0)), part->size());
    QVERIFY2(bar->rect().contains(place), part->metaObject()->className());
    const QSize least = part->minimumSizeHint().expandedTo(part->minimumSize());
    QVERIFY2(part->width() >= least.width(), part->metaObject()->className());
  }
  // Where a scene is less than a quarter of the window's height one cannot see what happens.
  QVERIFY(window.findChild<ui::SceneArea*>()->height() >= window.height() / 4);
}

void SmallScreenTest::namesCurvesBesideTheEnergies() {
  MainWindow window(ui::builtInScene("seven-weights"));
  window.setWindowState(Qt::WindowNoState);
  window.resize(kScreen - QSize(0, kTitleBar));
  window.show();
  window.controller()->stepOnce();
  tests::settle();
  const ui::ChartWidget& chart = *window.charts()->chart();
  int beside = 0;
  for (int x = 0; x < chart.width(); ++x)
    for (int y = 0; y < chart.height(); ++y) {
      if (chart.plot().entryAt(QPointF(x, y)) == nullptr) continue;
      QVERIFY(!chart.plotArea().contains(x, y));
      ++beside;
    }
  QVERIFY(beside > 0);
}

void SmallScreenTest::saysInPlaceOfTheSpeedHowSlowItIs() {
  MainWindow window(ui::builtInScene("seven-weights"));
  window.setWindowState(Qt::WindowNoState);
  window.resize(kScreen - QSize(0, kTitleBar));
  window.show();
  tests::settle();
  auto* bar = window.findChild<ui::PlaybackBar*>();
  const auto* pace = bar->findChild<QLabel*>("pace");
  const auto says = [bar](const QString& words) {
    for (const QLabel* label : bar->findChildren<QLabel*>())
      if (label->isVisible() && label->text() == words) return true;
    return false;
  };
  QVERIFY(!pace->isVisible());
  QVERIFY(says("Speed 1×"));
  bar->showKeptShare(0.25);
  QVERIFY(says("0.25× real time"));
  bar->showKeptShare(1);
  QVERIFY(says("Speed 1×"));
}

QTEST_MAIN(SmallScreenTest)
#include "small_screen_test.moc"
