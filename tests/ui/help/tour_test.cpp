#include "ui/help/tour.h"

#include <QAction>
#include <QDockWidget>
#include <QFontInfo>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/timeline.h"
#include "ui/view/scene_area.h"

using ui::Command;
using ui::Tour;

namespace {

class ShownWindow : public ui::MainWindow {
 public:
  explicit ShownWindow(QSize size = QSize(1280, 720))
      : MainWindow(ui::builtInScene("seven-weights")) {
    setWindowState(Qt::WindowNoState);
    resize(size);
    show();
    if (!QTest::qWaitForWindowActive(this)) qFatal("the window is not active");
  }

  Tour* begin() {
    commands().action(Command::kTour)->trigger();
    QCoreApplication::processEvents();
    return findChild<Tour*>();
  }

  QRect placeOf(const QWidget* widget) const {
    return {widget->mapTo(this, QPoint()), widget->size()};
  }
};

QPushButton* buttonOf(const Tour* tour, const char* words) {
  for (QPushButton* button : tour->findChildren<QPushButton*>())
    if (button->text() == words) return button;
  return nullptr;
}

/// A key pressed where the keyboard is.
void press(Qt::Key key) {
  QTest::keyClick(QApplication::focusWidget(), key);
}

}  // namespace

class TourTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void pointsAtFivePartsOfTheWindow();
  void itsWordsAreWholeAndCoverNothingTheyPointAt_data();
  void itsWordsAreWholeAndCoverNothingTheyPointAt();
  void isGoneThroughByKeys();
  void escapeEndsIt();
  void theButtonEndsIt();
  void keysOfTheWindowRestMeanwhile();
  void followsTheWindowsSize();
  void isDueOnce();
  void aPanelThatIsClosedIsNoTrouble();

 private:
  QTemporaryDir m_folder;
};

void TourTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void TourTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
}

void TourTest::pointsAtFivePartsOfTheWindow() {
  ShownWindow window;
  const QWidget* parts[] = {window.findChild<ui::SceneArea*>(),
                            window.findChild<ui::PlaybackBar*>(), window.findChild<ui::Timeline*>(),
                            window.findChild<QDockWidget*>("charts"),
                            window.findChild<QDockWidget*>("runs")};
  Tour* tour = window.begin();
  QCOMPARE(tour->hintCount(), 5);
  for (const QWidget* part : parts) {
    QCOMPARE(tour->pointedAt(), window.placeOf(part));
    if (part != parts[4]) buttonOf(tour, "Next")->click();
  }
}

void TourTest::itsWordsAreWholeAndCoverNothingTheyPointAt_data() {
  QTest::addColumn<QSize>("size");
  QTest::newRow("projector") << QSize(1280, 720);
  QTest::newRow("small") << QSize(960, 540);
  QTest::newRow("large") << QSize(1920, 1080);
}

void TourTest::itsWordsAreWholeAndCoverNothingTheyPointAt() {
  QFETCH(QSize, size);
  ShownWindow window(size);
  Tour* tour = window.begin();
  for (int hint = 0; hint < tour->hintCount(); ++hint) {
    const QRect bubble = tour->bubble()->geometry();
    QVERIFY(tour->rect().contains(bubble));
    QVERIFY2(!bubble.intersects(tour->pointedAt()), qPrintable(QString::number(hint)));
    for (const QLabel* label : tour->bubble()->findChildren<QLabel*>()) {
      QVERIFY(QFontInfo(label->font()).pointSizeF() >= 11.9);
      QVERIFY(tour->bubble()->rect().contains(label->geometry()));
      const int needed =
          label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
      QVERIFY2(label->height() >= needed, qPrintable(label->text()));
    }
    if (hint + 1 < tour->hintCount()) buttonOf(tour, "Next")->click();
  }
}

void TourTest::isGoneThroughByKeys() {
  ShownWindow window;
  const QPointer<Tour> tour = window.begin();
  for (int hint = 1; hint < 5; ++hint) {
    press(hint % 2 ? Qt::Key_Return : Qt::Key_Space);
    QCOMPARE(tour->hint(), hint);
  }
  // Round through its buttons, and not beyond.
  for (int i = 0; i < 5; ++i) {
    press(Qt::Key_Tab);
    QVERIFY(tour->isAncestorOf(QApplication::focusWidget()));
  }
  buttonOf(tour, "Back")->setFocus();
  press(Qt::Key_Return);
  QCOMPARE(tour->hint(), 3);
  press(Qt::Key_Return);
  press(Qt::Key_Return);
  QTRY_VERIFY(!tour);
}

void TourTest::escapeEndsIt() {
  ShownWindow window;
  const QPointer<Tour> tour = window.begin();
  press(Qt::Key_Escape);
  QTRY_VERIFY(!tour);
  QVERIFY(!window.controller()->isPlaying());
  press(Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
}

void TourTest::theButtonEndsIt() {
  ShownWindow window;
  const QPointer<Tour> tour = window.begin();
  QTest::mouseClick(buttonOf(tour, "Skip"), Qt::LeftButton);
  QTRY_VERIFY(!tour);
}

void TourTest::keysOfTheWindowRestMeanwhile() {
  ShownWindow window;
  const Tour* tour = window.begin();
  press(Qt::Key_Space);
  press(Qt::Key_C);
  press(Qt::Key_Right);
  QCOMPARE(window.controller()->time(), 0.0);
  QVERIFY(window.controller()->canCut());
  QVERIFY(!window.controller()->isPlaying());
  QVERIFY(tour->isVisible());
}

void TourTest::followsTheWindowsSize() {
  ShownWindow window;
  const Tour* tour = window.begin();
  window.resize(1000, 640);
  QTRY_COMPARE(tour->size(), window.size());
  QVERIFY(tour->rect().contains(tour->bubble()->geometry()));
}

void TourTest::isDueOnce() {
  QVERIFY(ui::isTourDue());
  {
    ShownWindow window;
    QVERIFY(!window.findChild<Tour*>());  // a window alone does not begin it
    QVERIFY(ui::isTourDue());
    window.begin();
    QVERIFY(!ui::isTourDue());
    QCOMPARE(window.findChildren<Tour*>().size(), 1);
    window.begin();
    QCOMPARE(window.findChildren<Tour*>().size(), 1);
  }
  QVERIFY(!ui::isTourDue());
}

void TourTest::aPanelThatIsClosedIsNoTrouble() {
  ShownWindow window;
  window.findChild<QDockWidget*>("charts")->close();
  Tour* tour = window.begin();
  for (int hint = 0; hint < 3; ++hint) buttonOf(tour, "Next")->click();
  QVERIFY(tour->pointedAt().isEmpty());
  QVERIFY(tour->rect().contains(tour->bubble()->geometry()));
}

QTEST_MAIN(TourTest)
#include "tour_test.moc"
