#include <cmath>

#include <QtTest>

#include "core/methods/method_list.h"

using core::ExplicitEuler;
using core::RungeKutta4;
using core::SemiImplicitEuler;

namespace {

constexpr auto kGrowth = [](double x) { return x; };
constexpr auto kLogistic = [](double x) { return x * (1 - x); };

/// Error at t = 1 of x' = x (1 − x) from x(0) = 0.1, whose solution is 1/(1 + 9 e^(−t)).
double errorOf(std::size_t method, int steps) {
  double x = 0.1;
  for (int i = 0; i < steps; ++i)
    core::withMethod(
        method, [&](auto unit) { x = unit.step(kLogistic, x, kLogistic(x), 1.0 / steps).end; });
  return std::abs(x - 1 / (1 + 9 * std::exp(-1.0)));
}

}  // namespace

/// The steps of all methods.
class StepTest : public QObject {
  Q_OBJECT

 private slots:
  void takesAnEulerStepWorkedByHand();
  void takesASemiImplicitStepWorkedByHand();
  void takesARungeKuttaStepWorkedByHand();
  void takesAsManySlopesAsItsRowSays();
  void staysWhereItIsInNoTime();
  void convergesAtExactlyItsStatedOrder_data();
  void convergesAtExactlyItsStatedOrder();
};

void StepTest::takesAnEulerStepWorkedByHand() {
  const auto stages = ExplicitEuler::step(kGrowth, 1.0, 1.0, 0.5);
  QCOMPARE(stages.slopes[0], 1.0);
  QCOMPARE(stages.end, 1.5);
}

void StepTest::takesASemiImplicitStepWorkedByHand() {
  // A weight at (1, 2) m with (3, 4) m/s that speeds up by (−2, −10) m/s² and heats by 6 W.
  const core::FlightState<> x{1, 2, 3, 4, 5}, k1{3, 4, -2, -10, 6};
  const core::FlightState<> end = SemiImplicitEuler::step(kGrowth, x, k1, 0.5).end;
  QVERIFY((end == core::FlightState<>{1 + 0.5 * 2, 2 + 0.5 * -1, 2, -1, 8}).all());
  const core::SwingState<> swing{1, 3, 5}, slope{3, -2, 6};
  QVERIFY((SemiImplicitEuler::step(kGrowth, swing, slope, 0.5).end == core::SwingState<>{2, 2, 8})
              .all());
}

void StepTest::takesARungeKuttaStepWorkedByHand() {
  const auto stages = RungeKutta4::step(kGrowth, 1.0, 1.0, 0.5);
  QCOMPARE(stages.slopes, (std::array{1.0, 1.25, 1.3125, 1.65625}));
  // 1 + h + h²/2 + h³/6 + h⁴/24
  QVERIFY(std::abs(stages.end - 1.6484375) < 1e-15);
}

void StepTest::takesAsManySlopesAsItsRowSays() {
  for (std::size_t i = 0; i < core::methods().size(); ++i)
    core::withMethod(i, [&](auto unit) {
      int calls = 0;
      const auto counted = [&](double x) {
        ++calls;
        return x;
      };
      const auto stages = unit.step(counted, 1.0, counted(1.0), 0.1);
      QCOMPARE(calls, decltype(unit)::kRow.slopesPerStep);
      QCOMPARE(static_cast<int>(stages.slopes.size()), decltype(unit)::kRow.slopesPerStep);
    });
}

void StepTest::staysWhereItIsInNoTime() {
  for (std::size_t i = 0; i < core::methods().size(); ++i)
    core::withMethod(i, [](auto unit) { QCOMPARE(unit.step(kLogistic, 0.3, 0.21, 0.0).end, 0.3); });
}

void StepTest::convergesAtExactlyItsStatedOrder_data() {
  QTest::addColumn<int>("index");
  for (std::size_t i = 0; i < core::methods().size(); ++i)
    QTest::newRow(std::string(core::methods()[i].id).c_str()) << static_cast<int>(i);
}

void StepTest::convergesAtExactlyItsStatedOrder() {
  QFETCH(int, index);
  const auto method = static_cast<std::size_t>(index);
  const double order = std::log2(errorOf(method, 32) / errorOf(method, 64));
  // What the next power of h adds at these steps is below 0.04; the smallest error is 10⁻¹⁴.
  QVERIFY2(std::abs(order - core::methods()[method].order) < 0.05,
           qPrintable(QString::number(order)));
}

QTEST_APPLESS_MAIN(StepTest)
#include "step_test.moc"
