#include "ui/control/translations.h"

#include <array>

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace ui {
namespace {

const QString kTranslator = QStringLiteral("angrycuts-translator");
const QString kOwnTexts = QStringLiteral(":/i18n");

// In the order of the enumeration.
constexpr std::array kLanguages{QLocale::AnyLanguage, QLocale::English, QLocale::Swedish,
                                QLocale::German,      QLocale::French,  QLocale::Spanish};
static_assert(kLanguages.size() == kLanguageCount);

/// The desktop knows the country and formats of its own, where it speaks that language.
QLocale localeOf(Language language) {
  const QLocale::Language wanted = kLanguages[static_cast<std::size_t>(language)];
  const QLocale desktop = QLocale::system();
  if (language == Language::kDesktop || desktop.language() == wanted) return desktop;
  return QLocale(wanted);
}

QTranslator* newTranslator() {
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(kTranslator);
  return translator;
}

void removeTranslators() {
  const auto old = QCoreApplication::instance()->findChildren<QTranslator*>(kTranslator);
  qDeleteAll(old);  // which also takes them out of use
}

void install(const QLocale& locale, const QString& name, const QString& folder) {
  QTranslator* translator = newTranslator();
  if (translator->load(locale, name, QStringLiteral("_"), folder)) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

/// English has texts of its own for what is counted.
void installEnglish() {
  QTranslator* translator = newTranslator();
  if (translator->load(QStringLiteral("angrycuts_en"), kOwnTexts))
    QCoreApplication::installTranslator(translator);
}

}  // namespace

QString nameOf(Language language) {
  static constexpr std::array kNames{"", "English", "Svenska", "Deutsch", "Français", "Español"};
  static_assert(kNames.size() == kLanguageCount);
  return QString::fromUtf8(kNames[static_cast<std::size_t>(language)]);
}

void speak(Language language) {
  const QLocale locale = localeOf(language);
  QLocale::setDefault(locale);
  removeTranslators();
  // The latest comes first where several have a text.
  installEnglish();
  install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(locale, QStringLiteral("angrycuts"), kOwnTexts);
}

QString withinSentence(const QString& name) {
  const QLocale locale;
  return locale.language() == QLocale::German ? name : locale.toLower(name);
}

}  // namespace ui
