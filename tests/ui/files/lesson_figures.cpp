#include "tests/ui/files/lesson_figures.h"

#include <QLocale>

#include "tests/ui/files/figures_by_subject.h"
#include "ui/chart/figure_text.h"

namespace tests {

QString LessonFigure::text() const {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  if (decimals == kFraction) return QStringLiteral("1/") + locale.toString(value, 'f', 0);
  if (decimals == kPower) return ui::figure(value);
  return locale.toString(value, 'f', decimals);
}

std::vector<LessonFigure> lessonFigures(const QString& lesson) {
  for (const auto subject : {methodFigures, swingFigures, flightFigures})
    if (const auto found = subject().find(lesson); found != subject().end()) return found->second();
  qFatal("no figures for %s", qPrintable(lesson));
}

}  // namespace tests
