#include "ui/control/scene_editor.h"

#include <QSignalSpy>
#include <QTest>

#include "core/scene/arrangement.h"

namespace {

core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.solvers = {core::Solver{.method = "rk4"}};
  return scene;
}

}  // namespace

class SceneEditorTest : public QObject {
  Q_OBJECT

 private slots:
  void handsOnADraftThatCanRun();
  void keepsTheSceneWhileTheDraftCannotRun();
  void mendsADraftWithAFurtherChange();
  void givesUpADraft();
  void putsTwoMethodsSideBySideWhereTheSceneNamesNone();
  void isModifiedUntilSavedOrReplaced();
};

void SceneEditorTest::handsOnADraftThatCanRun() {
  ui::SceneEditor editor(threeWeights());
  QSignalSpy changed(&editor, &ui::SceneEditor::sceneChanged);
  QVERIFY(editor.change([](core::Scene& scene) { scene.gravity = 1.62; }));
  QCOMPARE(changed.count(), 1);
  QCOMPARE(editor.scene()->gravity, 1.62);
}

void SceneEditorTest::keepsTheSceneWhileTheDraftCannotRun() {
  ui::SceneEditor editor(threeWeights());
  const auto before = editor.scene();
  QSignalSpy changed(&editor, &ui::SceneEditor::sceneChanged);
  QVERIFY(!editor.change([](core::Scene& scene) { scene.room.width = 0.5; }));
  QCOMPARE(changed.count(), 0);
  QCOMPARE(editor.scene(), before);
  QCOMPARE(editor.draft().room.width, 0.5);
  QVERIFY(!editor.problems().empty());
  QVERIFY(!editor.isModified());
}

void SceneEditorTest::mendsADraftWithAFurtherChange() {
  ui::SceneEditor editor(threeWeights());
  editor.change([](core::Scene& scene) { scene.room.width = 0.5; });
  QVERIFY(editor.change([](core::Scene& scene) { scene = core::withWeightCount(scene, 1); }));
  QCOMPARE(editor.scene()->room.width, 0.5);
  QVERIFY(editor.problems().empty());
}

void SceneEditorTest::givesUpADraft() {
  ui::SceneEditor editor(threeWeights());
  editor.change([](core::Scene& scene) { scene.room.width = 0.5; });
  editor.giveUpDraft();
  QCOMPARE(editor.draft().room.width, threeWeights().room.width);
  QVERIFY(editor.problems().empty());
}

void SceneEditorTest::putsTwoMethodsSideBySideWhereTheSceneNamesNone() {
  const ui::SceneEditor editor{core::Scene()};
  QCOMPARE(editor.scene()->solvers.size(), std::size_t{2});
  QCOMPARE(editor.scene()->solvers[0].method, std::string("rk4"));
  QCOMPARE(editor.scene()->solvers[1].method, std::string("euler"));
}

void SceneEditorTest::isModifiedUntilSavedOrReplaced() {
  ui::SceneEditor editor(threeWeights());
  QSignalSpy modified(&editor, &ui::SceneEditor::modifiedChanged);
  editor.change([](core::Scene& scene) { scene.gravity = 1; });
  QVERIFY(editor.isModified());
  editor.setSaved();
  QVERIFY(!editor.isModified());
  editor.change([](core::Scene& scene) { scene.gravity = 2; });
  editor.replace(threeWeights());
  QVERIFY(!editor.isModified());
  QCOMPARE(modified.count(), 4);
}

QTEST_MAIN(SceneEditorTest)
#include "scene_editor_test.moc"
