#include <cstdio>
#include <cstdlib>
#include <memory>
#include <variant>

#include <QApplication>
#include <QStringList>

#include "app/demonstration.h"
#include "app/exit_status.h"
#include "app/help_text.h"
#include "app/measure_command.h"
#include "app/options.h"
#include "app/scenes_command.h"
#include "app/simulate_command.h"
#include "app/window_command.h"
#include "core/system/streams.h"
#include "ui/control/first_scene.h"

namespace {

/// Where Qt would abort, because a display cannot be opened as a rule, the program ends with
/// a clear line instead. Remarks about a desktop are left out where none is needed.
void showMessage(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  if (type == QtFatalMsg) {
    std::_Exit(app::failure(app::kFailed, app::windowFailure(message.section('\n', 0, 0))));
  }
  if (app::hasDisplay() || type == QtCriticalMsg) {
    std::fprintf(stderr, "%s\n", qFormatLogMessage(type, context, message).toUtf8().constData());
  }
}

/// Runs what the command line asks for.
class Dispatch {
 public:
  Dispatch(int& argc, char** argv) : m_argc(argc), m_argv(argv) {}

  app::ExitStatus operator()(const app::HelpCall&) const { return app::printed(app::helpText()); }

  app::ExitStatus operator()(const app::VersionCall&) const {
    return app::printed(app::versionText());
  }

  app::ExitStatus operator()(const app::ScenesCall& call) const { return app::runScenes(call); }

  app::ExitStatus operator()(const app::SimulateCall& call) const {
    std::unique_ptr<QApplication> application;
    if (!call.chart.isEmpty()) application = applicationWithoutDisplay();
    return app::runSimulate(call);
  }

  app::ExitStatus operator()(const app::MeasureCall& call) const {
    std::unique_ptr<QApplication> application;
    if (!call.chart.isEmpty()) application = applicationWithoutDisplay();
    return app::runMeasure(call);
  }

  app::ExitStatus operator()(const app::WindowCall& call) const {
    if (app::hasDisplay()) {
      app::startNoBus();
      QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);  // docks float
      const QApplication application(m_argc, m_argv);
      return app::runWindow(call);
    }
    const std::unique_ptr<QApplication> application = applicationWithoutDisplay();
    return app::runDemonstration(call.scene.isEmpty() ? ui::kDemonstration : call.scene);
  }

 private:
  std::unique_ptr<QApplication> applicationWithoutDisplay() const {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    return std::make_unique<QApplication>(m_argc, m_argv);
  }

  int& m_argc;
  char** m_argv;
};

QStringList argumentsOf(int argc, char** argv) {
  QStringList arguments;
  for (int i = 1; i < argc; ++i) arguments.append(QString::fromLocal8Bit(argv[i]));
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  // A closed pipe is an error that can be told, not a reason to vanish.
  core::outliveClosedPipes();
  qInstallMessageHandler(showMessage);

  const app::CallOrError parsed = app::parseCall(argumentsOf(argc, argv));
  if (!parsed.call) return app::failure(app::kRefused, parsed.error);
  return std::visit(Dispatch(argc, argv), *parsed.call);
}
