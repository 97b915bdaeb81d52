// The page about the model says the same in every language.
#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include "tests/support/translated_languages.h"
#include "ui/files/long_text.h"

namespace {

QStringList translatedLanguages() {
  return tests::translatedLanguages(QDir(":/i18n"));
}

QStringList linesIn(const QString& language) {
  return ui::longText(QStringLiteral("help"), QStringLiteral("model"), language).split('\n');
}

bool isDisplayed(const QString& line) {
  return line.startsWith(QStringLiteral("    "));
}

QRegularExpression unicode(const QString& pattern) {
  return QRegularExpression(pattern, QRegularExpression::UseUnicodePropertiesOption);
}

QStringList allOf(const QRegularExpression& pattern, const QString& text, int group) {
  QStringList found;
  auto matches = pattern.globalMatch(text);
  while (matches.hasNext()) found << matches.next().captured(group);
  return found;
}

/// An equation with "…" for its words, of which languages may need more or fewer.
QString withoutWords(QString equation) {
  static const QString kWord =
      QStringLiteral("(?!(?:sin|cos|ln|min)(?!\\p{L}))(?:\\p{L}+’)*\\p{L}{2,}(?!\\p{L})");
  static const QRegularExpression kPhrase =
      unicode(QStringLiteral("(?<![\\p{L}’])%1(?: %1)*").arg(kWord));
  equation.replace(QStringLiteral("Σ"), QStringLiteral("∑"));  // no letter here
  return equation.replace(kPhrase, QStringLiteral("…")).simplified();
}

const QRegularExpression& code() {
  static const QRegularExpression kCode(QStringLiteral("`([^`]+)`"));
  return kCode;
}

QStringList equationsIn(const QString& line) {
  QStringList equations;
  for (const QString& equation : isDisplayed(line) ? QStringList(line) : allOf(code(), line, 1))
    equations << withoutWords(equation);
  return equations;
}

/// Beside the equations.
QStringList figuresIn(QString line) {
  static const QRegularExpression kFigure =
      unicode(QStringLiteral("[\\d⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+(?:[.,]\\d+)?(?:\\h?(?:µm|m/s|m|s|kg|rad)\\b)?"));
  QStringList figures = allOf(kFigure, line.remove(code()), 0);
  figures.replaceInStrings(QStringLiteral(","), QStringLiteral("."));
  figures.replaceInStrings(QStringLiteral("\u00A0"), QStringLiteral(" "));
  return figures;
}

/// What makes the line a heading, an item, a row or an equation; nothing for a paragraph.
QString kindOf(const QString& line) {
  static const QRegularExpression kKind(QStringLiteral("^(#+|-|\\||    )"));
  return kKind.match(line).captured();
}

}  // namespace

class ModelTextTest : public QObject {
  Q_OBJECT

 private slots:
  void isWrittenInEveryLanguage();
  void saysTheSameAsTheEnglishOne_data();
  void saysTheSameAsTheEnglishOne();
  void takesNothingButWordsFromEquations_data();
  void takesNothingButWordsFromEquations();
};

void ModelTextTest::isWrittenInEveryLanguage() {
  QVERIFY(linesIn("en").size() > 100);
  QVERIFY(translatedLanguages().size() >= 4);
  for (const QString& language : translatedLanguages())
    QVERIFY2(linesIn(language).size() > 1, qPrintable(language));
}

void ModelTextTest::saysTheSameAsTheEnglishOne_data() {
  QTest::addColumn<QString>("language");
  for (const QString& language : translatedLanguages())
    QTest::newRow(qPrintable(language)) << language;
}

void ModelTextTest::saysTheSameAsTheEnglishOne() {
  QFETCH(QString, language);
  const QStringList english = linesIn("en");
  const QStringList translated = linesIn(language);
  QCOMPARE(translated.size(), english.size());
  int equations = 0, figures = 0, headings = 0;
  for (int i = 0; i < english.size(); ++i) {
    const QStringList equationsHere = equationsIn(english[i]);
    const QStringList figuresHere = figuresIn(english[i]);
    const QString place = QStringLiteral("line %1 is “%2”").arg(i + 1).arg(translated[i]);
    const auto same = [&place](const auto& found, const auto& expected) {
      if (found != expected) qWarning().noquote() << place << found << expected;
      return found == expected;
    };
    QVERIFY(same(kindOf(translated[i]), kindOf(english[i])));
    QVERIFY(same(equationsIn(translated[i]), equationsHere));
    QVERIFY(same(figuresIn(translated[i]), figuresHere));
    QVERIFY(same(translated[i].count("**"), english[i].count("**")));
    const bool hasWords = !isDisplayed(english[i]) && english[i].size() > 60;
    QVERIFY2(!hasWords || translated[i] != english[i], qPrintable(place));
    headings += kindOf(english[i]).startsWith('#');
    equations += static_cast<int>(equationsHere.size());
    figures += static_cast<int>(figuresHere.size());
  }
  QVERIFY(headings > 10 && equations > 140 && figures > 50);
}

void ModelTextTest::takesNothingButWordsFromEquations_data() {
  QTest::addColumn<QString>("equation");
  QTest::addColumn<QString>("rest");
  QTest::newRow("none") << "κ = q L = ρ c_d A L / (2 m)"
                        << "κ = q L = ρ c_d A L / (2 m)";
  QTest::newRow("functions") << "(sin θ, −cos θ) + ln(1 + q)"
                             << "(sin θ, −cos θ) + ln(1 + q)";
  QTest::newRow("a letter after a word") << "−J n on a, +J n on b"
                                         << "−J n … a, +J n … b";
  QTest::newRow("elision") << "Q' = m κ L² |ω|³     perdue dans l’air"
                           << "Q' = m κ L² |ω|³ …";
  QTest::newRow("no spaces") << "v_n + gap/duration = 0"
                             << "v_n + …/… = 0";
  QTest::newRow("sums") << "kinetic + lost to air = drift"
                        << "… + … = …";
}

void ModelTextTest::takesNothingButWordsFromEquations() {
  QFETCH(QString, equation);
  QFETCH(QString, rest);
  QCOMPARE(withoutWords(equation), rest);
}

QTEST_GUILESS_MAIN(ModelTextTest)
#include "model_text_test.moc"
