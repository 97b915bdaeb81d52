#include "ui/view/scene_view.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/run/run.h"
#include "tests/ui/view/image_difference.h"

class SceneViewTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void cleanup();
  void showsTheRoomAndItsWeights();
  void followsTheRuns();
  void wheelZoomsAtThePointer();
  void draggingPansAndDoubleClickFits();
  void zoomSlotsEnlargeAndShrink();
  void staysFittedWhenResized();
  void keepsTheChosenPartWhenResized();
  void drawsTrailsUnlessHiddenOrCleared();
  void fitsARoomOfAnotherSize();
  void followsThePalette();
  void drawsWithoutOpenGl();
  void showsAnEmptyRoomWithoutRuns();

 private:
  /// Where the picture has the weight's color, which nothing else has.
  static QRect coloredPart(const QImage& image) {
    QRect part;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (image.pixel(x, y) == qRgb(255, 0, 255)) part |= QRect(x, y, 1, 1);
    return part;
  }

  QRect weightInPicture() { return coloredPart(m_view->grab().toImage()); }

  static std::shared_ptr<const core::Scene> fallingWeight(double roomWidth) {
    core::Scene scene;
    scene.airDensity = 0;
    scene.room.width = roomWidth;
    scene.weights.resize(1);
    scene.weights[0].radius = 0.1;
    scene.weights[0].color = core::Color{255, 0, 255};
    scene.weights[0].position = {1, 2.5};
    return std::make_shared<const core::Scene>(scene);
  }

  void wheel(QPoint place, int notches) {
    QWheelEvent event(place, m_view->mapToGlobal(place), QPoint(), QPoint(0, 120 * notches),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(m_view.get(), &event);
  }

  std::unique_ptr<core::Run> m_run;
  std::unique_ptr<ui::SceneView> m_view;
};

void SceneViewTest::init() {
  m_run = std::make_unique<core::Run>(fallingWeight(4), core::Solver{"rk4", 0.01});
  m_view = std::make_unique<ui::SceneView>();
  QPalette palette;
  palette.setColor(QPalette::Window, Qt::white);
  palette.setColor(QPalette::WindowText, Qt::black);
  m_view->setPalette(palette);
  m_view->resize(800, 600);
  m_view->setRuns({m_run.get()});
  m_view->show();
}

void SceneViewTest::cleanup() {
  m_view.reset();
}

void SceneViewTest::showsTheRoomAndItsWeights() {
  const QImage image = m_view->grab().toImage();
  QCOMPARE(image.size(), QSize(800, 600));
  const QRect weight = coloredPart(image);
  // A disc, wider than 0.15 m of a room that fills over half of the picture's width.
  QVERIFY(std::abs(weight.width() - weight.height()) <= 1);
  QVERIFY(weight.width() > 0.15 / 4 * 400);
  // The ground of the room, seen between grid lines.
  QVERIFY(shareOf(ui::Theme::light().room.rgb(), image) > 0.3);
}

void SceneViewTest::followsTheRuns() {
  const QRect before = weightInPicture();
  for (int i = 0; i < 50; ++i) m_run->advance();
  m_view->showTime(0.5);
  const QRect after = weightInPicture();
  // It fell by g t² / 2 = 1.226 m. Its diameter of 0.2 m gives the scale: the outline and the
  // soft edge take a pixel and a half on each side, and one of forty pixels is rounding.
  const double scale = (before.height() + 3) / 0.2;
  const double fallen = (after.center().y() - before.center().y()) / scale;
  QVERIFY2(std::abs(fallen - 1.226) < 0.05, qPrintable(QString::number(fallen)));
  QVERIFY(std::abs(after.center().x() - before.center().x()) <= 1);
}

void SceneViewTest::wheelZoomsAtThePointer() {
  const QRect before = weightInPicture();
  wheel(before.center(), 4);
  const QRect after = weightInPicture();
  QVERIFY(after.width() > 1.5 * before.width());
  QVERIFY((after.center() - before.center()).manhattanLength() <= 3);
}

void SceneViewTest::draggingPansAndDoubleClickFits() {
  const QRect before = weightInPicture();
  QTest::mousePress(m_view.get(), Qt::LeftButton, {}, {400, 300});
  QTest::mouseMove(m_view.get(), {440, 320});
  QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, {440, 320});
  QTest::mouseMove(m_view.get(), {100, 100});  // without the button nothing moves
  QCOMPARE(weightInPicture(), before.translated(40, 20));
  QTest::mouseDClick(m_view.get(), Qt::LeftButton, {}, {200, 300});
  QCOMPARE(weightInPicture(), before);
}

void SceneViewTest::zoomSlotsEnlargeAndShrink() {
  const int fitted = weightInPicture().width();
  m_view->zoomOut();
  QVERIFY(weightInPicture().width() < fitted);
  m_view->zoomIn();
  QVERIFY(std::abs(weightInPicture().width() - fitted) <= 1);
}

void SceneViewTest::staysFittedWhenResized() {
  const int before = weightInPicture().width();
  m_view->resize(400, 300);
  const int after = weightInPicture().width();
  // Half, and less for margins and soft edges that do not shrink.
  QVERIFY(after < before / 2 + 1 && after > before / 4);
}

void SceneViewTest::keepsTheChosenPartWhenResized() {
  wheel({400, 300}, 2);
  const int before = weightInPicture().width();
  m_view->resize(700, 600);
  QVERIFY(std::abs(weightInPicture().width() - before) <= 1);
}

void SceneViewTest::drawsTrailsUnlessHiddenOrCleared() {
  const auto shownAtHalfASecond = [this] { return m_view->grab().toImage(); };
  for (int i = 1; i <= 50; ++i) {
    m_run->advance();
    m_view->showTime(m_run->time());
  }
  QVERIFY(m_view->trails() != nullptr);
  const QImage with = shownAtHalfASecond();
  m_view->setTrailsShown(false);
  QVERIFY(m_view->trails() == nullptr);
  const QImage without = shownAtHalfASecond();
  QVERIFY(with != without);
  m_view->setTrailsShown(true);
  QCOMPARE(shownAtHalfASecond(), with);
  m_view->clearTrails();
  QCOMPARE(shownAtHalfASecond(), without);
}

void SceneViewTest::fitsARoomOfAnotherSize() {
  const int before = weightInPicture().width();
  wheel({400, 300}, 5);
  core::Run wide(fallingWeight(8), core::Solver{"rk4", 0.01});
  m_view->setRuns({&wide});
  QVERIFY(weightInPicture().width() < before);
}

void SceneViewTest::followsThePalette() {
  QPalette dark = m_view->palette();
  dark.setColor(QPalette::Window, Qt::black);
  dark.setColor(QPalette::WindowText, Qt::white);
  m_view->setPalette(dark);
  QVERIFY(shareOf(ui::Theme::darkTheme().room.rgb(), m_view->grab().toImage()) > 0.3);
}

void SceneViewTest::drawsWithoutOpenGl() {
  QSignalSpy changed(m_view.get(), &ui::SceneView::painterChanged);
  QCOMPARE(m_view->painterDescription(), "QPainter (no OpenGL 3.3)");
  m_view->setPainterChoice(ui::PainterChoice::kOpenGl);
  QCOMPARE(m_view->painterDescription(), "QPainter (no OpenGL 3.3)");
  m_view->setPainterChoice(ui::PainterChoice::kQPainter);
  QCOMPARE(m_view->painterDescription(), "QPainter");
  QCOMPARE(changed.count(), 2);
  QVERIFY(!weightInPicture().isEmpty());
}

void SceneViewTest::showsAnEmptyRoomWithoutRuns() {
  m_view->setRuns({});
  m_view->showTime(0);
  QVERIFY(weightInPicture().isEmpty());
}

QTEST_MAIN(SceneViewTest)
#include "scene_view_test.moc"
