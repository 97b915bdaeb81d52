#include "app/help_text.h"

#include <QCoreApplication>

#include "core/methods/method.h"
#include "ui/control/version.h"

namespace app {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::HelpText)
};

QString methodNames() {
  QStringList names;
  for (const core::Method& method : core::methods()) {
    names.append(QString::fromUtf8(method.id.data(), static_cast<qsizetype>(method.id.size())));
  }
  return names.join(QStringLiteral(", "));
}

}  // namespace

QString helpText() {
  return Texts::tr(
             "Usage:\n"
             "  angrycuts [SCENE]                     open the window\n"
             "  angrycuts scenes [--export FOLDER]    list the built-in scenes, or write them as "
             "files\n"
             "  angrycuts simulate SCENE [options]    run without a window\n"
             "  angrycuts measure SCENE [options]     measure speed against accuracy\n"
             "  angrycuts --help, --version\n"
             "\n"
             "A SCENE is a file or the name of a built-in scene. Where there is no display,\n"
             "angrycuts [SCENE] simulates the scene with each of its methods and writes what they\n"
             "gave into the current folder.\n"
             "\n"
             "Options of simulate:\n"
             "  --method NAME        %1 (rk4)\n"
             "  --step SECONDS       step of the method, from 1e-7 to 10 (1/60)\n"
             "  --tolerance X        instead of a step for dopri5, from 1e-14 to 1 (1e-9)\n"
             "  --until SECONDS      simulated time to reach, from 0 to 1e6 (10)\n"
             "  --cut SECONDS|never  when all ropes are cut (as the scene says)\n"
             "  --sample SECONDS     time between rows, from 1e-7 to 1e6 (0.1)\n"
             "  --trajectory FILE    where every weight is, as CSV; - is standard output\n"
             "  --energy FILE        where the energy is, as CSV; - is standard output\n"
             "  --events FILE        what happened, as CSV; - is standard output\n"
             "  --chart FILE         the energy chart as .png, .svg or .pdf\n"
             "With none of the four files it prints a short table.\n"
             "\n"
             "Options of measure, which tries all methods at many steps:\n"
             "  --until SECONDS      simulated time to measure over, from 0 to 1e6 (10)\n"
             "  --cut SECONDS|never  when all ropes are cut (as the scene says)\n"
             "  --csv FILE           all figures, as CSV; - is standard output\n"
             "  --chart FILE         error against cost as .png, .svg or .pdf\n"
             "With neither file it prints a short table.\n"
             "\n"
             "Exit status: 0; 2 where the call or the scene is refused; 3 where the numbers,\n"
             "or the events or steps within one step, got out of hand; 1 for anything else,\n"
             "such as a full disk.\n")
      .arg(methodNames());
}

QString versionText() {
  return QStringLiteral("angrycuts %1\n").arg(ui::version());
}

}  // namespace app
