// One lesson from the menu of pictures to the projector, as a teacher gives it: by keys, mouse and
// dialogs alone.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QSvgRenderer>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/support/fingerprint.h"
#include "tests/support/impacts.h"
#include "tests/support/settle.h"
#include "tests/support/shown_window.h"
#include "tests/support/window_hand.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/events_panel.h"
#include "ui/panels/lesson_chooser.h"
#include "ui/panels/lesson_panel.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/timeline.h"

using core::EventKind;
using tests::isImpact;
using tests::settle;

namespace {

const char* const kLesson = "two-weights";
constexpr double kFrame = 1.0 / 60;    // s
constexpr int kFramesUntilCut = 24;    // 0.4 s: the lesson itself cuts at 0.6 s
constexpr QSize kChartSize(254, 143);  // mm: for a slide

/// What the runs show, to the last bit.
std::vector<double> momentOf(const ui::RunController& controller) {
  std::vector<double> numbers{controller.time()};
  for (const core::Run* run : controller.runs()) {
    const std::vector<double> step = tests::fingerprint(*run);
    numbers.insert(numbers.end(), step.begin(), step.end());
    for (int i = 0; i < run->weightCount(); ++i) {
      const core::WeightState weight = run->weightAt(i, controller.time());
      numbers.insert(numbers.end(), {weight.position.x(), weight.position.y(), weight.velocity.x(),
                                     weight.velocity.y()});
    }
  }
  return numbers;
}

/// The window as it opens, in front, with a clock that the test moves.
class Window : public tests::ShownWindow {
 public:
  Window() : ShownWindow(ui::builtInScene("seven-weights")) { settle(); }

  std::vector<double> moment() const { return momentOf(*controller()); }
  /// In front again after a dialog, without a window manager.
  void comeBack() {
    activateWindow();
    QApplication::setActiveWindow(this);
    if (!QTest::qWaitForWindowActive(this)) qFatal("the window is not active");
    settle();
  }
  void pass(int frames) const {
    for (int i = 0; i < frames; ++i) controller()->passTime(kFrame);
  }

  /// Of the first run, each moment once.
  std::vector<double> impactTimes() const {
    return tests::timesOf(controller()->recording(0), isImpact);
  }

  bool says(const QString& words) const {
    return std::ranges::any_of(findChildren<QLabel*>(), [&](const QLabel* label) {
      return label->isVisible() && label->text() == words;
    });
  }
  QStringList visiblePanels() const {
    QStringList names;
    for (const QDockWidget* dock : findChildren<QDockWidget*>())
      if (dock->isVisible()) names << dock->objectName();
    names.sort();
    return names;
  }
};

/// Chooses the size of a slide and a name in the two dialogs of an export.
void exportChart(Window& window, const QString& file) {
  QTimer::singleShot(0, qApp, [file] {
    auto* size = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    QVERIFY(size);
    auto* preset = size->findChild<QComboBox*>();
    preset->setFocus();
    QTest::keyClick(preset, Qt::Key_Home);
    for (int i = 0; i < 2; ++i) QTest::keyClick(preset, Qt::Key_Down);
    QCOMPARE(size->findChildren<QSpinBox*>().at(0)->value(), kChartSize.width());
    QTimer::singleShot(0, qApp, [file] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog);
      auto* name = dialog->findChild<QLineEdit*>();
      name->setText(file);  // typed, its endings would be offered in a list
      QTest::keyClick(name, Qt::Key_Return);
      if (dialog->isVisible()) dialog->reject();
    });
    QTest::keyClick(size, Qt::Key_Return);
  });
  window.press(Qt::Key_E, Qt::ControlModifier);
  window.comeBack();
}

/// Light, and drawn on all over.
void verifyIsWholeChart(const QImage& picture) {
  QCOMPARE(picture.pixelColor(2, 2), QColor(Qt::white));
  int drawn[2][2] = {};
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.pixelColor(x, y) != QColor(Qt::white))
        ++drawn[2 * y / picture.height()][2 * x / picture.width()];
  // A file that breaks off leaves the lower half empty; axes and grid alone draw a thousandth.
  for (const auto& row : drawn)
    for (const int count : row) QVERIFY(count > picture.width() * picture.height() / 4 / 1000);
}

}  // namespace

class SessionTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void aLessonFromItsPictureToTheProjector();

 private:
  void opensTheLesson(Window& window);
  void playsAndCuts(Window& window);
  void stepsBackToTheFirstImpact(Window& window);
  void exportsTheChart(Window& window);
  void undoesAChange(Window& window);
  void playsTheSameAgain(Window& window);
  void presents(Window& window);
  void closesWithoutAQuestion(Window& window);

  QTemporaryDir m_folder;
  std::vector<double> m_impact;  // what the first one looked like
};

void SessionTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void SessionTest::aLessonFromItsPictureToTheProjector() {
  Window window;
  for (const auto station : {&SessionTest::opensTheLesson, &SessionTest::playsAndCuts,
                             &SessionTest::stepsBackToTheFirstImpact, &SessionTest::exportsTheChart,
                             &SessionTest::undoesAChange, &SessionTest::playsTheSameAgain,
                             &SessionTest::presents, &SessionTest::closesWithoutAQuestion}) {
    (this->*station)(window);
    if (QTest::currentTestFailed()) return;
  }
}

void SessionTest::opensTheLesson(Window& window) {
  window.press(Qt::Key_L, Qt::ControlModifier);
  auto* menu = window.findChild<ui::LessonChooser*>();
  QVERIFY(menu && QTest::qWaitForWindowActive(menu));
  QTest::keyClick(menu->list(), Qt::Key_Home);
  QTest::keyClick(menu->list(), Qt::Key_Right);
  QTest::keyClick(menu->list(), Qt::Key_Return);
  QVERIFY(!menu->isVisible());
  QVERIFY(window.controller()->scene() == ui::builtInScene(kLesson));
  window.comeBack();
  QVERIFY(window.findChild<ui::LessonPanel*>()->isVisible());
  QVERIFY(window.says(ui::lessonNamed(kLesson).look));
  QCOMPARE(window.time(), 0.0);
  QVERIFY(!window.controller()->isPlaying());
}

void SessionTest::playsAndCuts(Window& window) {
  window.press(Qt::Key_Space);
  QVERIFY(window.controller()->isPlaying());
  window.pass(kFramesUntilCut);
  // A step of the runs is a frame long: they have come to its end.
  QCOMPARE(window.time(), kFramesUntilCut * kFrame);
  QVERIFY(!window.controller()->run(0).allCut());
  window.press(Qt::Key_C);
  window.pass(1);
  QVERIFY(window.controller()->isPlaying());
  for (const core::Run* run : window.controller()->runs()) QVERIFY(run->allCut());
  const auto& events = window.controller()->recording(0).eventLog().events();
  const auto cut = std::ranges::find(events, EventKind::kCut, &core::Event::kind);
  QVERIFY(cut != events.end());
  QCOMPARE(cut->time, kFramesUntilCut * kFrame);
  while (window.impactTimes().size() < 4 && window.time() < 10) window.pass(1);
  QVERIFY(window.impactTimes().size() >= 4);
  window.press(Qt::Key_Space);
  QVERIFY(!window.controller()->isPlaying());
}

void SessionTest::stepsBackToTheFirstImpact(Window& window) {
  window.press(Qt::Key_End);
  const std::vector<double> end = window.moment();
  const std::vector<double> impacts = window.impactTimes();
  for (auto time = impacts.rbegin(); time != impacts.rend(); ++time) {
    if (*time >= end.front()) continue;
    window.press(Qt::Key_I, Qt::ShiftModifier);
    QCOMPARE(window.time(), *time);
  }
  m_impact = window.moment();

  // The same moment where nobody has gone beyond it.
  ui::RunController straight([] { return 0.0; });
  straight.setScene(window.editor()->scene());
  straight.play();
  for (int i = 0; i < kFramesUntilCut; ++i) straight.passTime(kFrame);
  straight.cutAll();
  straight.goTo(impacts.front());
  QVERIFY(m_impact == momentOf(straight));

  settle();
  QVERIFY(window.says(QString("%1 s").arg(impacts.front(), 0, 'f', 3)));
  window.findChild<QDockWidget*>("events")->raise();
  settle();
  const auto* list = window.findChild<ui::EventsPanel*>()->findChild<QTableView*>();
  const auto& events = window.controller()->recording(0).eventLog().events();
  const core::Event& marked = events[static_cast<std::size_t>(list->currentIndex().row())];
  QVERIFY(isImpact(marked));
  QCOMPARE(marked.time, impacts.front());

  window.findChild<QDockWidget*>("charts")->raise();
  settle();

  window.press(Qt::Key_End);
  QVERIFY(window.moment() == end);
  window.press(Qt::Key_Home);
  QCOMPARE(window.time(), 0.0);
  window.press(Qt::Key_I);
  QVERIFY(window.moment() == m_impact);
}

void SessionTest::exportsTheChart(Window& window) {
  const QString png = m_folder.filePath("lesson.png");
  const QString svg = m_folder.filePath("lesson.svg");
  exportChart(window, png);
  QVERIFY(window.statusBar()->currentMessage().contains("lesson.png"));
  const QImage picture(png);
  // 300 dots to the inch, to the pixel.
  QVERIFY(std::abs(picture.width() - kChartSize.width() / 25.4 * 300) <= 1);
  QVERIFY(std::abs(picture.height() - kChartSize.height() / 25.4 * 300) <= 1);
  verifyIsWholeChart(picture);

  exportChart(window, svg);
  QVERIFY(window.statusBar()->currentMessage().contains("lesson.svg"));
  QFile file(svg);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray content = file.readAll();
  QVERIFY(content.contains("Energy (J)"));
  QVERIFY(content.contains("Two weights"));
  QSvgRenderer drawing(content);
  QVERIFY(drawing.isValid());
  const QSizeF size = drawing.viewBoxF().size();
  QVERIFY(std::abs(size.width() / size.height() - 254.0 / 143) < 0.01);  // whole pixels
  QImage painted(picture.size(), QImage::Format_RGB32);
  painted.fill(Qt::white);
  QPainter painter(&painted);
  drawing.render(&painter);
  painter.end();
  verifyIsWholeChart(painted);
  // To save a picture changes nothing.
  QVERIFY(window.moment() == m_impact);
}

void SessionTest::undoesAChange(Window& window) {
  const core::Scene before = window.controller()->scene();
  QVERIFY(!window.isWindowModified());
  window.press(Qt::Key_Home);
  const tests::WindowHand hand(window);
  const Eigen::Vector2d weight = window.controller()->run(0).weight(1).position;
  const Eigen::Vector2d pivot = before.weights[1].rope->pivot;
  const Eigen::Vector2d down = pivot - Eigen::Vector2d(0, before.weights[1].rope->length);
  hand.drag(weight, down);
  settle();
  // Where a pixel lies, seen from the pivot.
  const double grain = 2 * hand.grain() / before.weights[1].rope->length;
  QVERIFY(std::abs(window.controller()->scene().weights[1].rope->angle) < grain);
  QVERIFY(window.controller()->scene().weights[0] == before.weights[0]);
  QVERIFY(window.isWindowModified());
  QVERIFY(window.impactTimes().empty());

  window.press(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.controller()->scene() == before);
  QVERIFY(!window.isWindowModified());
  QCOMPARE(window.controller()->run(0).weight(1).position, weight);
}

void SessionTest::playsTheSameAgain(Window& window) {
  window.press(Qt::Key_Space);
  window.pass(kFramesUntilCut);
  window.press(Qt::Key_C);
  window.press(Qt::Key_Space);
  QVERIFY(!window.controller()->isPlaying());
  window.press(Qt::Key_I);
  QVERIFY(window.moment() == m_impact);
}

void SessionTest::presents(Window& window) {
  settle();
  const QByteArray layout = window.saveState();
  const QRect geometry = window.geometry();
  const QStringList panels = window.visiblePanels();
  QVERIFY(panels.contains("runs"));
  window.press(Qt::Key_F11);
  settle();
  QVERIFY(window.isFullScreen());
  QVERIFY(window.findChild<ui::SceneArea*>()->isVisible());
  QCOMPARE(window.visiblePanels(), QStringList("charts"));
  QVERIFY(!window.menuBar()->isVisible() && !window.statusBar()->isVisible());
  QVERIFY(!window.findChild<ui::PlaybackBar*>()->isVisible());
  QVERIFY(!window.findChild<ui::Timeline*>()->isVisible());
  QVERIFY(window.moment() == m_impact);

  window.press(Qt::Key_Escape);
  settle();
  QVERIFY(!window.isFullScreen());
  QCOMPARE(window.visiblePanels(), panels);
  QCOMPARE(window.geometry(), geometry);
  QCOMPARE(window.saveState(), layout);
  QVERIFY(window.moment() == m_impact);
}

void SessionTest::closesWithoutAQuestion(Window& window) {
  QString question;
  QTimer::singleShot(0, this, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    question = box->text();
    box->button(QMessageBox::Cancel)->click();
  });
  window.press(Qt::Key_Q, Qt::ControlModifier);
  QCOMPARE(question, QString());
  QVERIFY(!window.isVisible());
}

QTEST_MAIN(SessionTest)
#include "session_test.moc"
