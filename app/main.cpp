#include <cstdio>
#include <cstdlib>
#include <memory>
#include <variant>

#include <QApplication>
#include <QLocale>
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
#include "ui/control/translations.h"

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

/// The environment's language and the numbers of files, in which other programs read them.
void speakAsCommand() {
  ui::speak(ui::Language::kDesktop);
  QLocale::setDefault(QLocale::c());
}

/// Runs what the command line asks for.
class Dispatch {
 public:
  Dispatch(int& argc, char** argv)
      : m_argc(argc), m_argv(argv), m_application(std::make_unique<QCoreApplication>(argc, argv)) {
    speakAsCommand();
  }

  app::ExitStatus operator()(const app::HelpCall&) { return app::printed(app::helpText()); }

  app::ExitStatus operator()(const app::VersionCall&) { return app::printed(app::versionText()); }

  app::ExitStatus operator()(const app::ScenesCall& call) { return app::runScenes(call); }

  app::ExitStatus operator()(const app::SimulateCall& call) {
    if (!call.chart.isEmpty()) drawWithoutDisplay();
    return app::runSimulate(call);
  }

  app::ExitStatus operator()(const app::MeasureCall& call) {
    if (!call.chart.isEmpty()) drawWithoutDisplay();
    return app::runMeasure(call);
  }

  app::ExitStatus operator()(const app::WindowCall& call) {
    if (app::hasDisplay()) {
      m_application.reset();
      app::startNoBus();
      QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);  // docks float
      m_application = std::make_unique<QApplication>(m_argc, m_argv);
      return app::runWindow(call);
    }
    drawWithoutDisplay();
    return app::runDemonstration(call.scene.isEmpty() ? ui::kDemonstration : call.scene);
  }

 private:
  void drawWithoutDisplay() {
    m_application.reset();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    m_application = std::make_unique<QApplication>(m_argc, m_argv);
    speakAsCommand();
  }

  int& m_argc;
  char** m_argv;
  std::unique_ptr<QCoreApplication> m_application;
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

  const QStringList arguments = argumentsOf(argc, argv);
  Dispatch dispatch(argc, argv);
  const app::CallOrError parsed = app::parseCall(arguments);
  if (!parsed.call) return app::failure(app::kRefused, parsed.error);
  return std::visit(dispatch, *parsed.call);
}
