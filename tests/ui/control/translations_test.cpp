#include "ui/control/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTest>

#include "core/scene/scene_limits.h"
#include "ui/control/problem_words.h"

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void countsInEnglishWhateverTheLanguage_data();
  void countsInEnglishWhateverTheLanguage();
};

void TranslationsTest::countsInEnglishWhateverTheLanguage_data() {
  QTest::addColumn<QLocale>("locale");
  QTest::newRow("C") << QLocale::c();
  QTest::newRow("English") << QLocale(QLocale::English);
  QTest::newRow("not translated") << QLocale(QLocale::Icelandic);
}

void TranslationsTest::countsInEnglishWhateverTheLanguage() {
  QFETCH(QLocale, locale);
  QLocale::setDefault(locale);
  ui::installTranslations(*QCoreApplication::instance());
  core::Scene scene;
  scene.gravity = -1;
  scene.airDensity = -1;
  QVERIFY(ui::problemWords(core::problemsIn(scene)).endsWith("(and 1 more problem)"));
  scene.room.friction = -1;
  QVERIFY(ui::problemWords(core::problemsIn(scene)).endsWith("(and 2 more problems)"));
}

QTEST_MAIN(TranslationsTest)
#include "translations_test.moc"
