#include "ui/view/scene_area.h"

#include <algorithm>
#include <memory>

#include <QTest>

#include "core/run/run.h"
#include "ui/view/camera.h"

using ui::SceneArea;
using ui::SceneView;

/// One view for all runs, or one for each.
class SceneAreaTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void showsAllRunsInOneViewUnlessSplit();
  void splitsIntoOneViewForEachRun();
  void doesNotSplitASingleRun();
  void splitViewsSeeTheSame();
  void splittingKeepsThePartThatIsSeen();
  void arrangesViewsWhereTheRoomIsLargest_data();
  void arrangesViewsWhereTheRoomIsLargest();

 private:
  /// @param count  1 to 4
  std::vector<const core::Run*> firstRuns(int count) const {
    std::vector<const core::Run*> runs;
    for (int i = 0; i < count; ++i) runs.push_back(&m_runs[static_cast<std::size_t>(i)]);
    return runs;
  }

  std::vector<core::Run> m_runs;
  std::unique_ptr<SceneArea> m_area;
};

void SceneAreaTest::init() {
  core::Scene scene;  // a room of 4 m × 3 m
  scene.weights.resize(1);
  scene.weights[0].position = {1, 1};
  const auto shared = std::make_shared<const core::Scene>(scene);
  m_runs.clear();
  for (const char* method : {"rk4", "euler", "semi-implicit-euler", "dopri5"})
    m_runs.emplace_back(shared, core::Solver{.method = method});
  m_area = std::make_unique<SceneArea>();
  m_area->resize(900, 600);
  m_area->setRuns(firstRuns(3));
  m_area->show();
}

void SceneAreaTest::showsAllRunsInOneViewUnlessSplit() {
  QCOMPARE(m_area->views().size(), std::size_t{1});
  QCOMPARE(m_area->views()[0]->size(), QSize(900, 600));
}

void SceneAreaTest::splitsIntoOneViewForEachRun() {
  m_area->setSplit(true);
  QCOMPARE(m_area->views().size(), std::size_t{3});
  m_area->setRuns(firstRuns(4));
  QCOMPARE(m_area->views().size(), std::size_t{4});
  m_area->setSplit(false);
  QCOMPARE(m_area->views().size(), std::size_t{1});
}

void SceneAreaTest::doesNotSplitASingleRun() {
  m_area->setRuns(firstRuns(1));
  m_area->setSplit(true);
  QCOMPARE(m_area->views().size(), std::size_t{1});
}

void SceneAreaTest::splitViewsSeeTheSame() {
  m_area->setSplit(true);
  const auto haveSameCamera = [this] {
    const std::vector<SceneView*>& views = m_area->views();
    return std::all_of(views.begin(), views.end(), [&](const SceneView* view) {
      return view->camera() == views[0]->camera() && view->isFitted() == views[0]->isFitted();
    });
  };
  QVERIFY(haveSameCamera());
  SceneView* second = m_area->views()[1];
  const double scale = second->camera().scale();
  second->zoomIn();
  QVERIFY(second->camera().scale() > scale);
  QVERIFY(haveSameCamera());
  QTest::mousePress(second, Qt::LeftButton, {}, {100, 100});
  QTest::mouseMove(second, {130, 90});
  QTest::mouseRelease(second, Qt::LeftButton, {}, {130, 90});
  QVERIFY(haveSameCamera());
  m_area->resize(811, 533);  // what no number of views divides
  QVERIFY(haveSameCamera());
  m_area->views()[2]->fitRoom();
  QVERIFY(haveSameCamera());
  QVERIFY(second->isFitted());
}

void SceneAreaTest::splittingKeepsThePartThatIsSeen() {
  m_area->zoomIn();
  const double scale = m_area->views()[0]->camera().scale();
  m_area->setSplit(true);
  for (const SceneView* view : m_area->views()) QCOMPARE(view->camera().scale(), scale);
}

void SceneAreaTest::arrangesViewsWhereTheRoomIsLargest_data() {
  QTest::addColumn<QSize>("size");
  QTest::addColumn<int>("columns");
  QTest::newRow("wide") << QSize(1600, 300) << 4;
  QTest::newRow("like the room") << QSize(1200, 900) << 2;
  QTest::newRow("tall") << QSize(300, 1200) << 1;
}

void SceneAreaTest::arrangesViewsWhereTheRoomIsLargest() {
  QFETCH(QSize, size);
  QFETCH(int, columns);
  m_area->setRuns(firstRuns(4));
  m_area->setSplit(true);
  m_area->resize(size);
  QCoreApplication::processEvents();
  int inFirstRow = 0;
  for (const SceneView* view : m_area->views()) {
    inFirstRow += view->y() == 0 ? 1 : 0;
    QCOMPARE(view->size(), m_area->views()[0]->size());
    QVERIFY(m_area->rect().contains(view->geometry()));
  }
  QCOMPARE(inFirstRow, columns);
}

QTEST_MAIN(SceneAreaTest)
#include "scene_area_test.moc"
