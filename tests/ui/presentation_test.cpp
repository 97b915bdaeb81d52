#include "ui/control/presentation.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "tests/support/controlled_runs.h"
#include "tests/support/settle.h"
#include "tests/support/shown_window.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/comparison_panel.h"
#include "ui/panels/lesson_panel.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/presentation_bar.h"
#include "ui/panels/presentation_header.h"
#include "ui/panels/timeline.h"
#include "ui/view/scene_area.h"

using ui::Command;

namespace {

/// Tells a widget from others. The tabs of panels are made anew now and then: they are told
/// apart by what they say.
QString nameOf(const QWidget* widget) {
  const auto* tabs = qobject_cast<const QTabBar*>(widget);
  if (!tabs) tabs = qobject_cast<const QTabBar*>(widget->parentWidget());
  if (tabs) return QString("tabs %1 %2").arg(tabs->count()).arg(tabs->tabText(0));
  return QString("%1 %2 %3")
      .arg(widget->metaObject()->className(), widget->objectName())
      .arg(reinterpret_cast<quintptr>(widget));
}

class LessonWindow : public tests::ShownWindow {
 public:
  explicit LessonWindow(const char* lesson = "seven-weights")
      : ShownWindow(ui::builtInScene(lesson)) {
    QCoreApplication::processEvents();
  }

  QDockWidget* dock(const char* name) const { return findChild<QDockWidget*>(name); }
  QLabel* sentence() const { return findChild<ui::PresentationHeader*>()->sentence(); }

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    ShownWindow::press(key, modifiers);
    QCoreApplication::processEvents();
  }

  QToolButton* barButton(Command command) const {
    for (QToolButton* button : presentation()->bar()->findChildren<QToolButton*>())
      if (button->defaultAction() == commands().action(command)) return button;
    return nullptr;
  }

  /// Where everything that can be seen is.
  QHash<QString, QRect> places() const {
    QHash<QString, QRect> places;
    const auto* comparison = findChild<ui::ComparisonPanel*>();
    for (const QWidget* widget : findChildren<QWidget*>()) {
      // Tables are as wide as their figures at the moment.
      if (!widget->isVisible() || comparison->isAncestorOf(widget)) continue;
      const QRect place(widget->mapTo(this, QPoint(0, 0)), widget->size());
      // Panels behind other panels lie outside.
      if (rect().intersects(place)) places.insert(nameOf(widget), place);
    }
    return places;
  }
};

QString describe(QRect rect) {
  return QString(" %1,%2 %3 × %4").arg(rect.x()).arg(rect.y()).arg(rect.width()).arg(rect.height());
}

}  // namespace

class PresentationTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void showsTheSceneAndOneChartInLargeType();
  void restoresTheLayoutExactly_data();
  void restoresTheLayoutExactly();
  void putsTheChartWhereTheRoomIsLargest();
  void controlsComeOnDemandAndGoAgain();
  void controlsWork();
  void escapeStopsTravellingFirst();
  void theSentenceIsOptional();
  void anotherLessonIsPresentedAtOnce();
  void otherChartsComeByKey();
  void closingThenForgetsNoPanel();
  void worksFromMenuAndButton();

 private:
  QTemporaryDir m_folder;
};

void PresentationTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void PresentationTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
}

void PresentationTest::showsTheSceneAndOneChartInLargeType() {
  LessonWindow window;
  const double usual = QApplication::font().pointSizeF();
  window.press(Qt::Key_F11);
  QVERIFY(window.isFullScreen());
  QVERIFY(window.findChild<ui::SceneArea*>()->isVisible());
  QVERIFY(window.charts()->isVisible());
  QVERIFY(!window.charts()->choosers()->isVisible());
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
    QCOMPARE(dock->isVisible(), dock->objectName() == "charts");
  QVERIFY(!window.menuBar()->isVisible() && !window.statusBar()->isVisible());
  QVERIFY(!window.findChild<ui::PlaybackBar*>()->isVisible());
  QVERIFY(!window.findChild<ui::Timeline*>()->isVisible());
  // A thirty-sixth of the height: one may sit nine times as far away as the picture is high.
  const int height = QFontInfo(window.charts()->font()).pixelSize();
  QVERIFY(height >= window.screen()->size().height() / 36);
  QVERIFY(window.charts()->font().pointSizeF() > usual);
  QVERIFY(window.findChild<ui::SceneArea*>()->views().front()->font().pointSizeF() > usual);
  QVERIFY(window.sentence()->font().pointSizeF() > usual);
  window.press(Qt::Key_F11);
  QVERIFY(!window.isFullScreen());
  for (const QWidget* widget : window.findChildren<QWidget*>())
    if (widget->font().pointSizeF() > usual)
      QVERIFY2(widget->inherits("ui::LargeLabel"), qPrintable(nameOf(widget)));
}

void PresentationTest::restoresTheLayoutExactly_data() {
  using Prepare = std::function<void(LessonWindow&)>;
  QTest::addColumn<Prepare>("prepare");
  const auto row = [](const char* name, const Prepare& prepare) { QTest::newRow(name) << prepare; };
  row("as at the start", [](LessonWindow&) {});
  row("other panels in front", [](LessonWindow& window) {
    window.dock("weights")->raise();
    window.dock("events")->raise();
  });
  row("no charts", [](LessonWindow& window) { window.dock("charts")->close(); });
  row("floating charts", [](LessonWindow& window) {
    window.dock("charts")->setFloating(true);
    window.dock("charts")->setGeometry(20, 30, 700, 300);  // on the small screen of tests
  });
  row("charts at the side", [](LessonWindow& window) {
    window.addDockWidget(Qt::RightDockWidgetArea, window.dock("charts"));
  });
  row("hidden lesson", [](LessonWindow& window) { window.press(Qt::Key_L); });
  row("no panels", [](LessonWindow& window) {
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) dock->close();
  });
  row("split views", [](LessonWindow& window) { window.press(Qt::Key_V); });
  row("other sizes", [](LessonWindow& window) {
    window.resize(1500, 900);
    window.resizeDocks({window.dock("charts")}, {300}, Qt::Vertical);
    window.resizeDocks({window.dock("runs")}, {500}, Qt::Horizontal);
  });
}

void PresentationTest::restoresTheLayoutExactly() {
  QFETCH(std::function<void(LessonWindow&)>, prepare);
  LessonWindow window;
  prepare(window);
  // What is laid out anew asks for more of it.
  tests::settle();
  const QByteArray layout = window.saveState();
  const QRect geometry = window.geometry();
  const auto places = window.places();
  window.press(Qt::Key_F11);
  QVERIFY(window.presentation()->isOn());
  window.press(Qt::Key_Escape);
  QVERIFY(!window.presentation()->isOn());
  tests::settle();
  QCOMPARE(window.geometry(), geometry);
  QCOMPARE(window.saveState(), layout);
  const auto restored = window.places();
  for (auto place = places.begin(); place != places.end(); ++place)
    QVERIFY2(
        restored.value(place.key()) == place.value(),
        qPrintable(place.key() + describe(place.value()) + describe(restored.value(place.key()))));
  QCOMPARE(restored.size(), places.size());
}

void PresentationTest::putsTheChartWhereTheRoomIsLargest() {
  LessonWindow window("counting-pi");
  window.presentation()->setOn(true);
  // Offscreen the screen is square: what counts is the window.
  window.resize(1920, 1080);
  QCOMPARE(window.dockWidgetArea(window.dock("charts")), Qt::BottomDockWidgetArea);
  window.files()->openBuiltIn("euler-gains-energy");
  QCOMPARE(window.dockWidgetArea(window.dock("charts")), Qt::RightDockWidgetArea);
}

void PresentationTest::controlsComeOnDemandAndGoAgain() {
  LessonWindow window;
  ui::PresentationBar* bar = window.presentation()->bar();
  QVERIFY(!bar->isVisible());
  window.press(Qt::Key_F11);
  QVERIFY(bar->isVisible());
  QVERIFY(window.rect().contains(bar->geometry()));
  const auto waitUntilGone = [&] {
    window.presentation()->hideTimer()->start(0);
    QTRY_VERIFY(!bar->isVisible());
    QCOMPARE(window.cursor().shape(), Qt::BlankCursor);
  };
  waitUntilGone();
  QTest::mouseMove(window.windowHandle(), QPoint(70, 180));
  QTRY_VERIFY(bar->isVisible());
  QVERIFY(window.presentation()->hideTimer()->isActive());
  QVERIFY(window.cursor().shape() != Qt::BlankCursor);
  waitUntilGone();
  window.press(Qt::Key_Period);
  QVERIFY(bar->isVisible());
  window.press(Qt::Key_Escape);
  QVERIFY(!bar->isVisible());
  QVERIFY(!window.presentation()->hideTimer()->isActive());
}

void PresentationTest::controlsWork() {
  LessonWindow window;
  window.press(Qt::Key_F11);
  QTest::mouseClick(window.barButton(Command::kPlay), Qt::LeftButton);
  QVERIFY(window.controller()->isPlaying());
  window.press(Qt::Key_Space);
  QVERIFY(!window.controller()->isPlaying());
  window.press(Qt::Key_Right);
  QCOMPARE(window.controller()->time(), 1.0 / 60);
  for (const QToolButton* button : window.presentation()->bar()->findChildren<QToolButton*>())
    QVERIFY2(!button->icon().isNull(), qPrintable(button->text()));
  QTest::mouseClick(window.barButton(Command::kPresent), Qt::LeftButton);
  QVERIFY(!window.presentation()->isOn());
}

void PresentationTest::escapeStopsTravellingFirst() {
  LessonWindow window;
  window.press(Qt::Key_F11);
  // Each look at the clock takes a second: one step between two frames.
  window.controller()->setStopwatch(tests::ticking(1));
  window.controller()->goTo(1000);
  QVERIFY(window.controller()->isTravelling());
  window.press(Qt::Key_Escape);
  QVERIFY(!window.controller()->isTravelling());
  QVERIFY(window.presentation()->isOn());
  window.press(Qt::Key_Escape);
  QVERIFY(!window.presentation()->isOn());
}

void PresentationTest::theSentenceIsOptional() {
  LessonWindow window;
  window.press(Qt::Key_F11);
  QVERIFY(window.sentence()->isVisible());
  QCOMPARE(window.sentence()->text(), ui::lessonNamed("seven-weights").look);
  window.press(Qt::Key_L);
  QVERIFY(!window.sentence()->isVisible());
  QVERIFY(!window.findChild<ui::LessonPanel*>()->isVisible());
  QVERIFY(!window.commands().action(Command::kLessonText)->isChecked());
  window.press(Qt::Key_L);
  QVERIFY(window.sentence()->isVisible());
  window.press(Qt::Key_L);
  window.press(Qt::Key_F11);
  // What was put away there is still here.
  QVERIFY(window.findChild<ui::LessonPanel*>()->isVisible());
  QVERIFY(window.commands().action(Command::kLessonText)->isChecked());
}

void PresentationTest::anotherLessonIsPresentedAtOnce() {
  LessonWindow window;
  window.press(Qt::Key_F11);
  window.press(Qt::Key_L);
  window.files()->openBuiltIn("pile");
  QVERIFY(window.sentence()->isVisible());
  QCOMPARE(window.sentence()->text(), ui::lessonNamed("pile").look);
  QVERIFY(!window.findChild<ui::LessonPanel*>()->isVisible());
  window.press(Qt::Key_F11);
  QVERIFY(window.findChild<ui::LessonPanel*>()->isVisible());
}

void PresentationTest::otherChartsComeByKey() {
  LessonWindow window;
  const auto* tabs = window.charts()->choosers()->findChild<QTabBar*>();
  window.press(Qt::Key_F11);
  const int before = tabs->currentIndex();
  window.press(Qt::Key_PageDown, Qt::ControlModifier);
  QCOMPARE(tabs->currentIndex(), before + 1);
}

void PresentationTest::closingThenForgetsNoPanel() {
  QByteArray layout;
  {
    LessonWindow window;
    layout = window.saveState();
    window.press(Qt::Key_F11);
    window.close();
  }
  QCOMPARE(ui::Settings().panels(), layout);
}

void PresentationTest::worksFromMenuAndButton() {
  LessonWindow window;
  window.commands().action(Command::kPresent)->trigger();
  QVERIFY(window.presentation()->isOn());
  window.commands().action(Command::kPresent)->trigger();
  QVERIFY(!window.presentation()->isOn());
  for (QToolButton* button : window.menuBar()->cornerWidget()->findChildren<QToolButton*>())
    if (button->defaultAction() == window.commands().action(Command::kPresent))
      QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(window.presentation()->isOn());
}

QTEST_MAIN(PresentationTest)
#include "presentation_test.moc"
