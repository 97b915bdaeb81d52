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

bool setGravity(ui::SceneEditor& editor, double gravity, const QString& key = {}) {
  return editor.change([=](core::Scene& scene) { scene.gravity = gravity; }, "gravity", key);
}

/// A room narrower than a meter is too small for the ropes of three weights.
bool setWidth(ui::SceneEditor& editor, double width, const QString& key = {}) {
  return editor.change([=](core::Scene& scene) { scene.room.width = width; }, "width", key);
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
  void undoesAndRedoesEveryChange();
  void aChangeAfterAnUndoForgetsWhatWasUndone();
  void aChangeThatChangesNothingIsNoStep();
  void undoLeadsThroughADraftThatCannotRun();
  void givingUpADraftCanBeDoneAgain();
  void changesWithOneKeyAreOneStep();
  void aDragBackToItsStartIsNoStep();
  void undoOfASavedSceneModifiesItAndRedoDoesNot();
  void aSceneSavedBesideADraftStaysModified();
  void undoLeadsBackToTheSceneThatWasReplaced();
  void savingForgetsWhetherOtherFilesAreAsTheyWere();
  void whatWasSavedAndUndoneIsLostToAnotherChange();
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

void SceneEditorTest::undoesAndRedoesEveryChange() {
  ui::SceneEditor editor(threeWeights());
  QVERIFY(!editor.canUndo());
  setGravity(editor, 1);
  editor.change([](core::Scene& scene) { scene.weights.erase(scene.weights.begin()); }, "removal");
  const core::Scene last = editor.draft();
  QCOMPARE(editor.undoWords(), QString("removal"));
  QSignalSpy changed(&editor, &ui::SceneEditor::sceneChanged);
  editor.undo();
  QCOMPARE(editor.scene()->weights.size(), std::size_t{3});
  editor.undo();
  QVERIFY(*editor.scene() == threeWeights());
  QVERIFY(editor.draft() == threeWeights());
  QVERIFY(!editor.canUndo());
  editor.undo();  // of nothing
  editor.redo();
  QCOMPARE(editor.redoWords(), QString("removal"));
  editor.redo();
  QVERIFY(*editor.scene() == last);
  QVERIFY(!editor.canRedo());
  QCOMPARE(changed.count(), 4);
}

void SceneEditorTest::aChangeAfterAnUndoForgetsWhatWasUndone() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1);
  editor.undo();
  setGravity(editor, 2);
  QVERIFY(!editor.canRedo());
  editor.undo();
  QCOMPARE(editor.scene()->gravity, 9.81);
}

void SceneEditorTest::aChangeThatChangesNothingIsNoStep() {
  ui::SceneEditor editor(threeWeights());
  QSignalSpy changed(&editor, &ui::SceneEditor::sceneChanged);
  QVERIFY(setGravity(editor, 9.81));
  QVERIFY(!editor.canUndo());
  QVERIFY(!editor.isModified());
  QCOMPARE(changed.count(), 0);
}

void SceneEditorTest::undoLeadsThroughADraftThatCannotRun() {
  ui::SceneEditor editor(threeWeights());
  const auto first = editor.scene();
  setWidth(editor, 0.5);
  setWidth(editor, 6);
  QCOMPARE(editor.scene()->room.width, 6.0);
  editor.undo();
  QCOMPARE(editor.draft().room.width, 0.5);
  QVERIFY(!editor.problems().empty());
  QVERIFY(*editor.scene() == *first);  // what ran at the time
  QSignalSpy changed(&editor, &ui::SceneEditor::sceneChanged);
  editor.undo();
  QVERIFY(editor.problems().empty());
  QCOMPARE(editor.draft().room.width, 4.0);
  QCOMPARE(changed.count(), 0);  // it runs all the time
  editor.redo();
  QVERIFY(!editor.problems().empty());
  editor.redo();
  QCOMPARE(editor.scene()->room.width, 6.0);
}

void SceneEditorTest::givingUpADraftCanBeDoneAgain() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1);
  setWidth(editor, 0.5);
  setWidth(editor, 0.6);
  editor.giveUpDraft();
  QCOMPARE(editor.draft().room.width, 4.0);
  QCOMPARE(editor.draft().gravity, 1.0);
  editor.redo();
  QCOMPARE(editor.draft().room.width, 0.5);
}

void SceneEditorTest::changesWithOneKeyAreOneStep() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1, "gravity");
  setWidth(editor, 0.5, "width");  // cannot run on the way
  setWidth(editor, 5, "width");
  editor.closeStep();
  setWidth(editor, 7, "width");
  editor.undo();
  QCOMPARE(editor.draft().room.width, 5.0);
  editor.undo();
  QCOMPARE(editor.draft().room.width, 4.0);
  QVERIFY(editor.problems().empty());
  QCOMPARE(editor.draft().gravity, 1.0);
  editor.redo();
  QCOMPARE(editor.draft().room.width, 5.0);
}

void SceneEditorTest::aDragBackToItsStartIsNoStep() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1, "gravity");
  QVERIFY(editor.isModified());
  setGravity(editor, 9.81, "gravity");
  QVERIFY(!editor.isModified());
  QVERIFY(!editor.canUndo());
}

void SceneEditorTest::undoOfASavedSceneModifiesItAndRedoDoesNot() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1, "gravity");
  editor.setSavedAs("moon.json");
  setGravity(editor, 2, "gravity");
  QVERIFY(editor.isModified());
  editor.undo();
  QCOMPARE(editor.draft().gravity, 1.0);  // what was saved is a step to come back to
  QVERIFY(!editor.isModified());
  editor.undo();
  QVERIFY(editor.isModified());
  editor.redo();
  QVERIFY(!editor.isModified());
}

void SceneEditorTest::aSceneSavedBesideADraftStaysModified() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1);
  setWidth(editor, 0.5);
  editor.setSaved();
  QVERIFY(editor.isModified());  // the width is not in the file
  editor.undo();
  QVERIFY(!editor.isModified());
}

void SceneEditorTest::undoLeadsBackToTheSceneThatWasReplaced() {
  ui::SceneEditor editor(threeWeights());
  editor.setSavedAs("three.json");
  setGravity(editor, 1);
  QSignalSpy replaced(&editor, &ui::SceneEditor::sceneReplaced);
  QSignalSpy named(&editor, &ui::SceneEditor::fileChanged);
  core::Scene other = core::withWeightCount(threeWeights(), 5);
  editor.replace(other, "five.json", "opening of five.json");
  QVERIFY(!editor.isModified());
  QCOMPARE(editor.file(), QString("five.json"));
  setGravity(editor, 2);
  editor.undo();
  QVERIFY(!editor.isModified());
  editor.undo();
  QCOMPARE(editor.scene()->weights.size(), std::size_t{3});
  QCOMPARE(editor.scene()->gravity, 1.0);
  QCOMPARE(editor.file(), QString("three.json"));
  QVERIFY(editor.isModified());
  editor.undo();
  QVERIFY(!editor.isModified());
  editor.redo();
  editor.redo();
  QCOMPARE(editor.file(), QString("five.json"));
  QVERIFY(!editor.isModified());
  QCOMPARE(editor.scene()->weights.size(), std::size_t{5});
  QCOMPARE(replaced.count(), 3);
  QCOMPARE(named.count(), 3);
}

void SceneEditorTest::savingForgetsWhetherOtherFilesAreAsTheyWere() {
  ui::SceneEditor editor(threeWeights());
  editor.setSavedAs("one.json");
  editor.replace(core::withWeightCount(threeWeights(), 5), "two.json");
  editor.setSavedAs("one.json");
  editor.undo();
  QCOMPARE(editor.file(), QString("one.json"));
  QVERIFY(editor.isModified());  // the file holds five weights by now
}

void SceneEditorTest::whatWasSavedAndUndoneIsLostToAnotherChange() {
  ui::SceneEditor editor(threeWeights());
  setGravity(editor, 1);
  editor.setSaved();
  editor.undo();
  setGravity(editor, 2);
  QVERIFY(editor.isModified());  // at the same place of the history, but not the same
}

QTEST_MAIN(SceneEditorTest)
#include "scene_editor_test.moc"
