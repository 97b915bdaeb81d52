#include "ui/control/scene_announcer.h"

#include <memory>

#include <QSignalSpy>
#include <QTest>

#include "ui/control/event_navigator.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"

namespace {

/// Two balls that fall from different heights and bounce.
core::Scene bouncing() {
  core::Scene scene;
  scene.airDensity = 0;
  scene.room.restitution = 0.9;
  for (const double height : {0.5, 1.0}) {
    core::Weight ball;
    ball.radius = 0.05;
    ball.position = {height, height};
    scene.weights.push_back(ball);
  }
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

}  // namespace

class SceneAnnouncerTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void saysWhichWeightIsSelected();
  void saysWhatHappened();
  void sumsUpWhatHappensMeanwhile();
  void staysSilentWhileGoingBack();
  void saysNothingOfAnotherScene();

 private:
  std::unique_ptr<ui::SceneEditor> m_editor;
  std::unique_ptr<ui::Selection> m_selection;
  std::unique_ptr<ui::RunController> m_controller;
  std::unique_ptr<ui::EventNavigator> m_events;
  std::unique_ptr<ui::SceneAnnouncer> m_announcer;
  std::unique_ptr<QSignalSpy> m_said;
};

void SceneAnnouncerTest::init() {
  m_said.reset();
  m_announcer.reset();
  m_events.reset();
  m_editor = std::make_unique<ui::SceneEditor>(bouncing());
  m_selection = std::make_unique<ui::Selection>(m_editor.get());
  m_controller = std::make_unique<ui::RunController>([] { return 0.0; });
  m_events = std::make_unique<ui::EventNavigator>(m_controller.get());
  m_announcer = std::make_unique<ui::SceneAnnouncer>(m_controller.get(), m_events.get(),
                                                     m_selection.get(), nullptr);
  m_controller->setScene(m_editor->scene());
  m_said = std::make_unique<QSignalSpy>(m_announcer.get(), &ui::SceneAnnouncer::said);
}

void SceneAnnouncerTest::saysWhichWeightIsSelected() {
  m_selection->select(1);
  QCOMPARE(m_said->size(), 1);
  QCOMPARE(m_said->takeFirst().first().toString(), QString("Weight 2 selected"));
  m_selection->clear();
  QVERIFY(m_said->wait());
  QCOMPARE(m_said->takeFirst().first().toString(), QString("No weight selected"));
}

void SceneAnnouncerTest::saysWhatHappened() {
  // 0.45 m take 0.303 s.
  m_controller->goTo(0.35);
  QCOMPARE(m_said->size(), 1);
  QCOMPARE(m_said->first().first().toString(),
           QString("Impact on the floor: weight 1, at 0.303 s"));
}

void SceneAnnouncerTest::sumsUpWhatHappensMeanwhile() {
  m_selection->select(0);
  for (const double time : {0.35, 0.5, 1.0, 2.0}) m_controller->goTo(time);
  QCOMPARE(m_said->size(), 1);  // the selection; the rest is too soon
  QVERIFY(m_said->wait());
  QCOMPARE(m_said->size(), 2);
  int impacts = 0;
  for (const core::Event& event : m_controller->recording(0).eventLog().events())
    if (event.kind == core::EventKind::kImpactFloor && event.time <= 2) ++impacts;
  QVERIFY(impacts > 2);
  QVERIFY(
      m_said->last().first().toString().contains(QString("Impact on the floor: %1").arg(impacts)));
  // Nothing is left to say.
  QVERIFY(!m_said->wait(2 * ui::SceneAnnouncer::kPause));
}

void SceneAnnouncerTest::staysSilentWhileGoingBack() {
  m_controller->goTo(0.35);
  m_said->clear();
  m_controller->showTime(0.1);
  QVERIFY(!m_said->wait(2 * ui::SceneAnnouncer::kPause));
  // Forward again it is heard again.
  m_controller->showTime(0.35);
  QCOMPARE(m_said->size(), 1);
}

void SceneAnnouncerTest::saysNothingOfAnotherScene() {
  m_selection->select(0);
  m_controller->goTo(0.35);
  m_said->clear();
  m_controller->reset();
  QVERIFY(!m_said->wait(2 * ui::SceneAnnouncer::kPause));
}

QTEST_MAIN(SceneAnnouncerTest)
#include "scene_announcer_test.moc"
