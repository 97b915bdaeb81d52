#include "core/recording/csv.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/scene/angle.h"

namespace {

core::WeightState stateIn(core::Phase phase) {
  core::WeightState state;
  state.phase = phase;
  state.position = {0.1, 2};
  state.velocity = {-1e-9, 1.0 / 3};
  state.angle = core::radians(70);
  state.angularVelocity = core::radians(-12.5);
  state.tension = 5;
  return state;
}

core::Event eventOf(core::EventKind kind, int weight, int other) {
  core::Event event;
  event.time = 0.9;
  event.kind = kind;
  event.weight = weight;
  event.other = other;
  event.position = {0.02, 0.5};
  event.energyLost = 0.25;
  return event;
}

QString trajectoryRow(core::Phase phase) {
  std::string csv;
  core::appendTrajectoryRow(csv, 0.30000000000000004, 2, stateIn(phase));
  return QString::fromStdString(csv);
}

QString eventRow(const core::Event& event) {
  std::string csv;
  core::appendEventRow(csv, event);
  return QString::fromStdString(csv);
}

}  // namespace

class CsvTest : public QObject {
  Q_OBJECT

 private slots:
  void namesTheColumns();
  void givesAnglesOnlyWhileTethered();
  void writesTheLedger();
  void leavesFieldsOfEventsEmpty();
  void writesNumbersThatReadBack_data();
  void writesNumbersThatReadBack();
  void appendsToWhatIsThere();
};

void CsvTest::namesTheColumns() {
  QCOMPARE(core::trajectoryHeader(),
           std::string_view("time,weight,phase,x,y,vx,vy,angle,angular_velocity\r\n"));
  QCOMPARE(core::energyHeader(),
           std::string_view("time,kinetic,potential,lost_to_air,lost_to_impacts,lost_to_ropes,"
                            "lost_to_friction,numerical_drift\r\n"));
  QCOMPARE(core::eventHeader(), std::string_view("time,event,weight,other,x,y,energy_lost\r\n"));
}

void CsvTest::givesAnglesOnlyWhileTethered() {
  const QString common = "0.1,2,-1e-09,0.3333333333333333,";
  QCOMPARE(trajectoryRow(core::Phase::kTethered),
           "0.30000000000000004,2,tethered," + common + "70,-12.5\r\n");
  QCOMPARE(trajectoryRow(core::Phase::kSlack), "0.30000000000000004,2,slack," + common + ",\r\n");
  QCOMPARE(trajectoryRow(core::Phase::kFlying), "0.30000000000000004,2,flying," + common + ",\r\n");
  QCOMPARE(trajectoryRow(core::Phase::kResting),
           "0.30000000000000004,2,resting," + common + ",\r\n");
}

void CsvTest::writesTheLedger() {
  core::Energies energies;
  energies.kinetic = 1;
  energies.potential = 2.5;
  energies.lostToAir = 3e-5;
  energies.lostToImpacts = 4;
  energies.lostToRopes = 5;
  energies.lostToFriction = 6;
  energies.numericalDrift = -7e-12;
  std::string csv;
  core::appendEnergyRow(csv, 0.5, energies);
  QCOMPARE(csv, std::string("0.5,1,2.5,3e-05,4,5,6,-7e-12\r\n"));
}

void CsvTest::leavesFieldsOfEventsEmpty() {
  QCOMPARE(eventRow(eventOf(core::EventKind::kCut, -1, -1)), QString("0.9,cut,,,,,0.25\r\n"));
  QCOMPARE(eventRow(eventOf(core::EventKind::kCut, 3, -1)),
           QString("0.9,cut,3,,0.02,0.5,0.25\r\n"));
  QCOMPARE(eventRow(eventOf(core::EventKind::kImpactFloor, 0, -1)),
           QString("0.9,impact-floor,0,,0.02,0.5,0.25\r\n"));
  QCOMPARE(eventRow(eventOf(core::EventKind::kImpactWeight, 0, 12)),
           QString("0.9,impact-weight,0,12,0.02,0.5,0.25\r\n"));
}

void CsvTest::writesNumbersThatReadBack_data() {
  QTest::addColumn<double>("number");
  QTest::newRow("sixtieth") << 1.0 / 60;
  QTest::newRow("smallest") << std::numeric_limits<double>::denorm_min();
  QTest::newRow("largest") << std::numeric_limits<double>::max();
  QTest::newRow("negative zero") << -0.0;
  QTest::newRow("many digits") << -123456789.12345679;
}

void CsvTest::writesNumbersThatReadBack() {
  QFETCH(double, number);
  core::Energies energies;
  energies.kinetic = number;
  std::string csv;
  core::appendEnergyRow(csv, 0, energies);
  bool isNumber = false;
  const double read = QString::fromStdString(csv).section(',', 1, 1).toDouble(&isNumber);
  QVERIFY(isNumber);
  QVERIFY(read == number);
  QCOMPARE(std::signbit(read), std::signbit(number));
}

void CsvTest::appendsToWhatIsThere() {
  std::string csv(core::energyHeader());
  core::appendEnergyRow(csv, 0, {});
  core::appendEnergyRow(csv, 1, {});
  QVERIFY(QString::fromStdString(csv).endsWith("drift\r\n0,0,0,0,0,0,0,0\r\n1,0,0,0,0,0,0,0\r\n"));
}

QTEST_APPLESS_MAIN(CsvTest)
#include "csv_test.moc"
