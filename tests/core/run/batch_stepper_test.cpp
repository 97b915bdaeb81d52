#include "core/run/batch_stepper.h"

#include <cmath>
#include <vector>

#include <QtTest>

#include "core/run/stepper.h"

using core::BatchStepper;
using core::Body;
using core::Mode;
using core::Piece;

namespace {

constexpr double kGravity = 9.81;
constexpr double kStep = 1.0 / 30;

Body bodyNumber(int i) {
  return {.mass = 0.03 * (i + 1),
          .radius = 0.02,
          .drag = i % 5 == 2 ? 0 : 0.02 * i,
          .hasRope = true,
          .rigid = false,
          .length = 0.4 + 0.13 * i,
          .pivot = {1, 2}};
}

/// Weights on ropes and in flight, in turn and in runs.
Piece pieceNumber(int i) {
  Piece piece;
  piece.end = kStep;
  piece.mode = (i / 3) % 2 == 0 ? Mode::kSwing : Mode::kFlight;
  if (piece.mode == Mode::kSwing) {
    piece.beginState << -3 + 0.7 * i, 0, 2 - 0.6 * i, 0, 0.1 * i;
  } else {
    piece.beginState << 0.1 * i, 1.5, 3 - i, 0.5 * i, 0.2;
  }
  return piece;
}

bool haveTheSameBits(const Piece& a, const Piece& b) {
  return (a.endState == b.endState).all() && (a.beginSlope == b.beginSlope).all() &&
         (a.endSlope == b.endSlope).all() && a.straight == b.straight;
}

}  // namespace

class BatchStepperTest : public QObject {
  Q_OBJECT

 private slots:
  void takesTheStepsOfSingleWeightsToTheBit_data();
  void takesTheStepsOfSingleWeightsToTheBit();
  void leavesWhatNeedsCareToTheStepper();
};

void BatchStepperTest::takesTheStepsOfSingleWeightsToTheBit_data() {
  QTest::addColumn<QByteArray>("method");
  QTest::addColumn<int>("count");
  for (const core::Method& method : core::methods()) {
    if (method.isAdaptive) continue;
    for (const int count : {1, 8, 9, 61})
      QTest::addRow("%s, %d weights", method.id.data(), count)
          << QByteArray(method.id.data()) << count;
  }
}

void BatchStepperTest::takesTheStepsOfSingleWeightsToTheBit() {
  QFETCH(QByteArray, method);
  QFETCH(int, count);
  const core::Method& row = *core::findMethod(method.toStdString());
  core::Stepper alone(row, kGravity, 0);
  BatchStepper together(row, kGravity);
  std::vector<Piece> expected, pieces;
  for (int i = 0; i < count; ++i) {
    expected.push_back(pieceNumber(i));
    pieces.push_back(pieceNumber(i));
  }
  for (int i = 0; i < count; ++i) alone.fill(bodyNumber(i), expected[i]);
  for (int i = 0; i < count; ++i) {
    QVERIFY(BatchStepper::takes(pieces[i]));
    together.add(bodyNumber(i), pieces[i]);
  }
  QCOMPARE(together.finish(), alone.evaluations());
  for (int i = 0; i < count; ++i) QVERIFY(haveTheSameBits(pieces[i], expected[i]));
  QCOMPARE(together.finish(), 0);
}

void BatchStepperTest::leavesWhatNeedsCareToTheStepper() {
  Piece piece;
  for (const Mode mode : {Mode::kHeld, Mode::kSlide}) {
    piece.mode = mode;
    QVERIFY(!BatchStepper::takes(piece));
  }
  piece.mode = Mode::kFlight;
  piece.settled = true;
  QVERIFY(!BatchStepper::takes(piece));
}

QTEST_APPLESS_MAIN(BatchStepperTest)
#include "batch_stepper_test.moc"
