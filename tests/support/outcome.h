#pragma once

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace tests {

/// What a call of another program left behind.
struct Outcome {
  int status = -1;  ///< -1: it did not start, crashed, or took more than a minute
  QByteArray output;
  QByteArray error;
};

inline Outcome outcomeOf(
    const QString& program, const QStringList& arguments,
    const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) {
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(program, arguments);
  const bool ended =
      process.waitForFinished(60'000) && process.exitStatus() == QProcess::NormalExit;
  return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
          process.readAllStandardError()};
}

}  // namespace tests
