#include "ui/control/run_words.h"

#include <QCoreApplication>
#include <QLocale>

#include "core/methods/method.h"
#include "core/run/run.h"
#include "ui/control/quantity_text.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::RunWords)
};

// The names in core's method table, for translators to find.
[[maybe_unused]] constexpr const char* kMethodNames[] = {
    QT_TRANSLATE_NOOP("ui::RunWords", "Euler (explicit)"),
    QT_TRANSLATE_NOOP("ui::RunWords", "Euler (semi-implicit)"),
    QT_TRANSLATE_NOOP("ui::RunWords", "Runge–Kutta 4"),
    QT_TRANSLATE_NOOP("ui::RunWords", "Dormand–Prince 5(4)"),
    QT_TRANSLATE_NOOP("ui::RunWords", "Reference"),
};

}  // namespace

QString methodWords(const core::Method& method) {
  return Words::tr(std::string(method.name).c_str());
}

QString runWords(const core::Solver& solver) {
  const core::Method& method = *core::findMethod(solver.method);
  if (!method.isOffered) return methodWords(method);
  if (method.isAdaptive)
    return Words::tr("%1, tolerance %2").arg(methodWords(method), quantityText(solver.tolerance));
  return Words::tr("%1, %2 s").arg(methodWords(method), fractionText(solver.step));
}

QString stopWords(const core::Run& run) {
  const QString when = QLocale().toString(run.time(), 'f', 3);
  switch (run.status()) {
    case core::RunStatus::kRunning:
      return {};
    case core::RunStatus::kDiverged:
      return Words::tr("%1, diverged at %2 s. Its last finite state is shown; try a smaller step.")
          .arg(runWords(run.solver()), when);
    case core::RunStatus::kEndless:
      return Words::tr("%1, stopped at %2 s: one step held more impacts than a step may.")
          .arg(runWords(run.solver()), when);
    case core::RunStatus::kStalled:
      return Words::tr(
                 "%1, stopped at %2 s: the tolerance asks for more or smaller steps than "
                 "can be taken.")
          .arg(runWords(run.solver()), when);
  }
  return {};
}

}  // namespace ui
