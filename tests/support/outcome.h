#pragma once

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace tests {

/// What a call of another program left behind.
struct Outcome {
  int status = -1;  ///< -1: it did not start, crashed, or took more than two minutes
  QByteArray output;
  QByteArray error;
};

/// @param folder  to call it in; empty: where the test itself runs
inline Outcome outcomeOf(
    const QString& program, const QStringList& arguments,
    const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment(),
    const QString& folder = {}) {
  QProcess process;
  process.setProcessEnvironment(environment);
  process.setWorkingDirectory(folder);
  process.start(program, arguments);
  const bool ended =
      process.waitForFinished(120'000) && process.exitStatus() == QProcess::NormalExit;
  return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
          process.readAllStandardError()};
}

}  // namespace tests
