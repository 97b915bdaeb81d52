#include "ui/control/translations.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTest>

#include "core/scene/scene_limits.h"
#include "ui/control/problem_words.h"

using ui::Language;

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { ui::speak(Language::kEnglish); }
  void countsInEnglish_data();
  void countsInEnglish();
  void writesNamesWithinSentences();
};

void TranslationsTest::countsInEnglish_data() {
  QTest::addColumn<Language>("language");
  QTest::newRow("English") << Language::kEnglish;
  // The environment of tests is in no language.
  QTest::newRow("not translated") << Language::kDesktop;
}

void TranslationsTest::countsInEnglish() {
  QFETCH(Language, language);
  ui::speak(language);
  core::Scene scene;
  scene.gravity = -1;
  scene.airDensity = -1;
  QVERIFY(ui::problemWords(core::problemsIn(scene)).endsWith("(and 1 more problem)"));
  scene.room.friction = -1;
  QVERIFY(ui::problemWords(core::problemsIn(scene)).endsWith("(and 2 more problems)"));
}

void TranslationsTest::writesNamesWithinSentences() {
  ui::speak(Language::kEnglish);
  QCOMPARE(ui::withinSentence("Air density"), QString("air density"));
  ui::speak(Language::kGerman);
  QCOMPARE(ui::withinSentence("Luftdichte"), QString("Luftdichte"));
}

QTEST_MAIN(TranslationsTest)
#include "translations_test.moc"
