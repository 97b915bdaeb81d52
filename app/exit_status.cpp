#include "app/exit_status.h"

#include <cstdio>

#include <QCoreApplication>

#include "ui/files/output_file.h"

namespace app {

ExitStatus failure(ExitStatus status, const QString& line) {
  std::fprintf(stderr, "angrycuts: %s\n", line.toUtf8().constData());
  return status;
}

ExitStatus printed(const QString& text) {
  ui::OutputFile output;
  if (output.openStandardOutput() && output.write(text.toStdString()) && output.finish()) {
    return kSuccess;
  }
  return failure(
      kFailed,
      QCoreApplication::translate("app::ExitStatus", "standard output: %1").arg(output.error()));
}

}  // namespace app
