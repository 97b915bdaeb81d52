#include "ui/control/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace ui {

void installTranslations(QCoreApplication& application) {
  auto* translator = new QTranslator(&application);
  const bool loaded =
      translator->load(QLocale(), QStringLiteral("angrycuts"), QStringLiteral("_"), ":/i18n") ||
      translator->load(QStringLiteral(":/i18n/angrycuts_en"));
  if (loaded) QCoreApplication::installTranslator(translator);
}

}  // namespace ui
