#include "ui/control/selection.h"

#include <QSignalSpy>
#include <QTest>

#include "core/scene/arrangement.h"
#include "ui/control/scene_editor.h"

using ui::SceneEditor;
using ui::Selection;

namespace {

core::Scene threeWeights() {
  return core::withWeightCount(core::Scene(), 3);
}

}  // namespace

class SelectionTest : public QObject {
  Q_OBJECT

 private slots:
  void startsWithNone();
  void tellsOfEachChangeOnce();
  void selectsNoneForAnIndexWithoutAWeight();
  void walksRoundTheWeights();
  void staysWhileItsWeightIsChanged();
  void endsWithItsWeight();
  void endsWithItsScene();
};

void SelectionTest::startsWithNone() {
  SceneEditor editor(threeWeights());
  QCOMPARE(Selection(&editor).weight(), std::nullopt);
}

void SelectionTest::tellsOfEachChangeOnce() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  QSignalSpy selected(&selection, &Selection::weightSelected);
  selection.select(2);
  selection.select(2);
  QCOMPARE(selection.weight(), 2);
  selection.clear();
  selection.clear();
  QCOMPARE(selection.weight(), std::nullopt);
  QCOMPARE(selected, (QList<QList<QVariant>>{{2}, {-1}}));
}

void SelectionTest::selectsNoneForAnIndexWithoutAWeight() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  for (const int weight : {3, -1, -2}) {
    selection.select(1);
    selection.select(weight);
    QCOMPARE(selection.weight(), std::nullopt);
  }
}

void SelectionTest::walksRoundTheWeights() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  QList<int> walked;
  for (int i = 0; i < 4; ++i) {
    selection.selectNext();
    walked << *selection.weight();
  }
  selection.clear();
  for (int i = 0; i < 4; ++i) {
    selection.selectPrevious();
    walked << *selection.weight();
  }
  QCOMPARE(walked, (QList<int>{0, 1, 2, 0, 2, 1, 0, 2}));
  editor.change([](core::Scene& scene) { scene.weights.clear(); });
  selection.selectNext();
  QCOMPARE(selection.weight(), std::nullopt);
}

void SelectionTest::staysWhileItsWeightIsChanged() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  selection.select(1);
  QSignalSpy selected(&selection, &Selection::weightSelected);
  editor.change([](core::Scene& scene) { scene.weights[1].mass = 2; });
  QVERIFY(!editor.change([](core::Scene& scene) { scene.weights[1].mass = -2; }));
  QCOMPARE(selection.weight(), 1);
  QCOMPARE(selected.count(), 0);
}

void SelectionTest::endsWithItsWeight() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  selection.select(2);
  editor.change([](core::Scene& scene) { scene.weights.pop_back(); });
  QCOMPARE(selection.weight(), std::nullopt);
}

void SelectionTest::endsWithItsScene() {
  SceneEditor editor(threeWeights());
  Selection selection(&editor);
  selection.select(1);
  editor.replace(threeWeights());
  QCOMPARE(selection.weight(), std::nullopt);
}

QTEST_GUILESS_MAIN(SelectionTest)
#include "selection_test.moc"
