#include "core/trade/measurement_csv.h"

#include <QtTest>

class MeasurementCsvTest : public QObject {
  Q_OBJECT

 private slots:
  void writesOneRowForEachPoint();
};

void MeasurementCsvTest::writesOneRowForEachPoint() {
  core::MeasuredPoint good{{.method = "rk4", .step = 0.125}, 80, 640, 1.5e-7, 0.25, 1234.5,
                           core::RunStatus::kRunning,        10};
  core::MeasuredPoint diverged = good;
  diverged.solver.step = 1.0 / 3;
  diverged.status = core::RunStatus::kDiverged;
  diverged.reached = 2.5;
  core::MeasuredPoint stopped = diverged;
  stopped.status = core::RunStatus::kEndless;
  core::Measurement measurement;
  measurement.curves = {{core::findMethod("rk4"), {good, diverged, stopped}}};
  QCOMPARE(QByteArray::fromStdString(core::measurementCsv(measurement)),
           QByteArray("method,setting,steps,evaluations,max_position_error,max_energy_drift,"
                      "nanoseconds_per_simulated_second,outcome\r\n"
                      "rk4,0.125,80,640,1.5e-07,0.25,1234.5,ok\r\n"
                      "rk4,0.3333333333333333,80,640,1.5e-07,0.25,1234.5,diverged at 2.5\r\n"
                      "rk4,0.3333333333333333,80,640,1.5e-07,0.25,1234.5,diverged at 2.5\r\n"));
}

QTEST_APPLESS_MAIN(MeasurementCsvTest)
#include "measurement_csv_test.moc"
