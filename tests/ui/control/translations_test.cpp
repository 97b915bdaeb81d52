#include "ui/control/translations.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLocale>
#include <QPushButton>
#include <QTest>

#include "core/scene/scene_limits.h"
#include "ui/control/problem_words.h"
#include "ui/control/quantity_text.h"

using ui::Language;

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { ui::speak(Language::kEnglish); }
  void countsInEnglish_data();
  void countsInEnglish();
  void speaksOneLanguageAtATime_data();
  void speaksOneLanguageAtATime();
  void comesBackToEnglish();
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

void TranslationsTest::speaksOneLanguageAtATime_data() {
  QTest::addColumn<Language>("language");
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("cancel");
  QTest::addColumn<QString>("half");
  QTest::newRow("Swedish") << Language::kSwedish << "Arkiv"
                           << "Avbryt"
                           << "0,5";
  QTest::newRow("German") << Language::kGerman << "Datei"
                          << "Abbrechen"
                          << "0,5";
  QTest::newRow("French") << Language::kFrench << "Fichier"
                          << "Annuler"
                          << "0,5";
  QTest::newRow("Spanish") << Language::kSpanish << "Archivo"
                           << "Cancelar"
                           << "0,5";
  QTest::newRow("English") << Language::kEnglish << "File"
                           << "Cancel"
                           << "0.5";
}

void TranslationsTest::speaksOneLanguageAtATime() {
  QFETCH(Language, language);
  QFETCH(QString, file);
  QFETCH(QString, cancel);
  QFETCH(QString, half);
  for (const Language before : {Language::kSpanish, Language::kSwedish}) ui::speak(before);
  ui::speak(language);
  QCOMPARE(QCoreApplication::translate("ui::MainMenu", "&File").remove('&'), file);
  // A text of Qt's own.
  const QDialogButtonBox box(QDialogButtonBox::Cancel);
  QCOMPARE(box.button(QDialogButtonBox::Cancel)->text().remove('&'), cancel);
  QCOMPARE(ui::quantityText(0.5), half);
}

void TranslationsTest::comesBackToEnglish() {
  const QString before = QCoreApplication::translate("ui::MainMenu", "&File");
  ui::speak(Language::kFrench);
  QVERIFY(QCoreApplication::translate("ui::MainMenu", "&File") != before);
  ui::speak(Language::kEnglish);
  QCOMPARE(QCoreApplication::translate("ui::MainMenu", "&File"), before);
}

void TranslationsTest::writesNamesWithinSentences() {
  ui::speak(Language::kEnglish);
  QCOMPARE(ui::withinSentence("Air density"), QString("air density"));
  ui::speak(Language::kGerman);
  QCOMPARE(ui::withinSentence("Luftdichte"), QString("Luftdichte"));
}

QTEST_MAIN(TranslationsTest)
#include "translations_test.moc"
