#include "ui/control/undo_history.h"

#include <QTest>

#include "core/scene/arrangement.h"

namespace {

constexpr std::size_t kMany = 100000;

core::Scene manyWeights() {
  core::Scene scene;
  scene.weights.resize(kMany);
  return scene;
}

/// All weights become as heavy as this.
ui::SceneChange changeOfAll(const core::Scene& before, double mass) {
  core::Scene after = before;
  for (core::Weight& weight : after.weights) weight.mass = mass;
  return {before, after};
}

ui::UndoStep stepOf(ui::SceneChange change, const QString& words) {
  return {words, {}, std::move(change), nullptr, nullptr, std::nullopt};
}

}  // namespace

class UndoHistoryTest : public QObject {
  Q_OBJECT

 private slots:
  void aChangeLeadsThereAndBack_data();
  void aChangeLeadsThereAndBack();
  void aChangeOfOneWeightAmongManyIsSmall();
  void forgetsTheOldestStepsWhereMemoryEnds();
  void keepsTheLatestStepHoweverLarge();
};

void UndoHistoryTest::aChangeLeadsThereAndBack_data() {
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("removed");
  QTest::addColumn<int>("added");
  QTest::newRow("nothing") << 0 << 0 << 0;
  QTest::newRow("one changed") << 4 << 1 << 1;
  QTest::newRow("the first removed") << 0 << 1 << 0;
  QTest::newRow("the last removed") << 8 << 1 << 0;
  QTest::newRow("added at the end") << 9 << 0 << 3;
  QTest::newRow("more than before") << 2 << 3 << 7;
  QTest::newRow("fewer than before") << 2 << 5 << 2;
  QTest::newRow("all removed") << 0 << 9 << 0;
}

void UndoHistoryTest::aChangeLeadsThereAndBack() {
  QFETCH(int, first);
  QFETCH(int, removed);
  QFETCH(int, added);
  const core::Scene before = core::withWeightCount(core::Scene(), 9);
  core::Scene after = before;
  const auto begin = after.weights.begin() + first;
  after.weights.erase(begin, begin + removed);
  core::Weight heavy;
  heavy.mass = 7;
  after.weights.insert(after.weights.begin() + first, static_cast<std::size_t>(added), heavy);
  const ui::SceneChange change(before, after);
  QCOMPARE(change.isEmpty(), removed + added == 0);
  core::Scene scene = before;
  change.redo(scene);
  QVERIFY(scene == after);
  change.undo(scene);
  QVERIFY(scene == before);
}

void UndoHistoryTest::aChangeOfOneWeightAmongManyIsSmall() {
  const core::Scene before = manyWeights();
  core::Scene after = before;
  after.weights[kMany / 2].mass = 7;
  QVERIFY(ui::SceneChange(before, after).bytes() < 2000);
}

void UndoHistoryTest::forgetsTheOldestStepsWhereMemoryEnds() {
  const core::Scene before = manyWeights();
  const std::size_t bytes = changeOfAll(before, 0).bytes();
  QVERIFY(bytes >= 2 * kMany * sizeof(core::Weight));
  ui::UndoHistory history(3 * bytes + bytes / 2);
  for (int i = 1; i <= 5; ++i) history.add(stepOf(changeOfAll(before, i), QString::number(i)));
  QCOMPARE(history.position(), 5);
  QCOMPARE(history.stepBefore(2)->words.text(), QString("3"));
  QVERIFY(!history.stepBefore(3));
}

void UndoHistoryTest::keepsTheLatestStepHoweverLarge() {
  ui::UndoHistory history(1);
  const core::Scene before = core::withWeightCount(core::Scene(), 9);
  for (int i = 1; i <= 2; ++i) history.add(stepOf(changeOfAll(before, i), QString::number(i)));
  QCOMPARE(history.undoStep()->words.text(), QString("2"));
  QVERIFY(!history.stepBefore(1));
}

QTEST_GUILESS_MAIN(UndoHistoryTest)
#include "undo_history_test.moc"
