#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QSlider>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTranslator>
#include <QtTest>

#include "tests/ui/files/lesson_figures.h"
#include "ui/control/commands.h"
#include "ui/control/event_words.h"
#include "ui/files/lessons.h"
#include "ui/files/long_text.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"

using tests::LessonFigure;

namespace {

const QString kSheets = QStringLiteral("lessons");
const QString kEnglish = QStringLiteral("en");
constexpr int kParts = 6;  // below the title: goal, needs, steps, questions, what is seen, one more
constexpr int kSeen = 4;   // which of them quotes the numbers

QString sheet(const QString& lesson, const QString& language) {
  return ui::longText(kSheets, lesson, language);
}

/// All sheets and the guide by their names, as far as they are written.
std::vector<std::pair<QString, QString>> textsIn(const QString& language) {
  std::vector<std::pair<QString, QString>> texts;
  for (const ui::Lesson& lesson : ui::lessons())
    texts.emplace_back(lesson.name, sheet(lesson.name, language));
  const QString guide = ui::longText(QStringLiteral("help"), QStringLiteral("guide"), language);
  if (!guide.isEmpty()) texts.emplace_back(QStringLiteral("guide"), guide);
  return texts;
}

/// What stands below each heading; the title's line first.
QStringList partsOf(const QString& text) {
  return text.split(QStringLiteral("\n## "));
}

/// Lines that begin a list's item.
qsizetype itemsIn(const QString& part) {
  static const QRegularExpression kItem("^(-|\\d+\\.) ", QRegularExpression::MultilineOption);
  return part.count(kItem);
}

QStringList between(const QString& mark, const QString& text) {
  const QString escaped = QRegularExpression::escape(mark);
  const QString inner = QStringLiteral("(?<!\\*)%1([^*`\n]+)%1(?!\\*)").arg(escaped);
  QStringList found;
  auto matches = QRegularExpression(inner).globalMatch(text);
  while (matches.hasNext()) found << matches.next().captured(1);
  return found;
}

/// A number as it stands in a text, of one of the forms that LessonFigure::text() has.
const QString kNumber = QStringLiteral("1/\\d+|\\d+(?:[.,]\\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?");
const QString kUnit = QStringLiteral("m/s²|m/s|kg|mm|m|s|J|N|%|°");

QStringList numbersIn(const QString& text) {
  // Letters and digits after a unit make a word of it: "1 mark" is not a length.
  const QRegularExpression number(
      QStringLiteral("(?<![\\w.,/])(%1)(?:\\h?(%2)(?![\\w/]))?").arg(kNumber, kUnit),
      QRegularExpression::UseUnicodePropertiesOption);
  QStringList found;
  auto matches = number.globalMatch(text);
  while (matches.hasNext()) {
    const QRegularExpressionMatch match = matches.next();
    found << (match.captured(1) + ' ' + match.captured(2)).trimmed();
  }
  return found;
}

/// Weights are counted by name, as in "weight 4".
bool countsWeights(const QString& number) {
  return number.size() == 1;
}

const std::vector<LessonFigure>& figuresOf(const QString& lesson) {
  static std::map<QString, std::vector<LessonFigure>> known;
  auto [place, isNew] = known.try_emplace(lesson);
  if (isNew) place->second = tests::lessonFigures(lesson);
  return place->second;
}

/// All that the window of this moment has written on it.
QStringList wordsOf(const ui::MainWindow& window) {
  QStringList words;
  for (const QAction* action : window.findChildren<QAction*>()) words << action->text();
  for (const QLabel* label : window.findChildren<QLabel*>()) words << label->text();
  for (const auto* button : window.findChildren<QAbstractButton*>()) words << button->text();
  for (const auto* dock : window.findChildren<QDockWidget*>()) words << dock->windowTitle();
  for (const QTabBar* bar : window.findChildren<QTabBar*>())
    for (int i = 0; i < bar->count(); ++i) words << bar->tabText(i);
  for (const QComboBox* box : window.findChildren<QComboBox*>())
    for (int i = 0; i < box->count(); ++i) words << box->itemText(i);
  for (const auto* view : window.findChildren<QAbstractItemView*>())
    for (int i = 0; view->model() && i < view->model()->columnCount(); ++i)
      words << view->model()->headerData(i, Qt::Horizontal).toString();
  for (const QSlider* slider : window.findChildren<QSlider*>()) words << slider->accessibleName();
  for (const ui::Lesson& lesson : ui::lessons()) words << lesson.title;
  words << ui::eventWords(core::EventKind::kImpactEast);
  for (QString& word : words) word.remove('&').remove(QStringLiteral("…"));
  return words;
}

/// The keys of all commands as the window of this moment writes them; arrows as they are engraved.
QStringList keyNames() {
  const ui::Commands commands;
  QStringList keys;
  for (const QAction* action : commands.all())
    for (const QKeySequence& sequence : action->shortcuts())
      keys << sequence.toString(QKeySequence::NativeText);
  const auto nameOf = [](Qt::Key key) {
    return QKeySequence(key).toString(QKeySequence::NativeText);
  };
  keys.replaceInStrings(nameOf(Qt::Key_Right), QStringLiteral("→"));
  keys.replaceInStrings(nameOf(Qt::Key_Left), QStringLiteral("←"));
  keys << QKeySequence(Qt::SHIFT).toString(QKeySequence::NativeText).remove('+');
  return keys;
}

/// Speaks a language as long as it lives.
class Speaking {
 public:
  explicit Speaking(const QString& language) {
    QLocale::setDefault(QLocale(language));
    m_isKnown = m_translator.load(QStringLiteral(":/i18n/angrycuts_") + language);
    if (m_isKnown) QCoreApplication::installTranslator(&m_translator);
  }
  ~Speaking() {
    QCoreApplication::removeTranslator(&m_translator);
    QLocale::setDefault(QLocale::c());
  }
  bool isKnown() const { return m_isKnown; }

 private:
  QTranslator m_translator;
  bool m_isKnown;
};

void addLanguageRows() {
  QTest::addColumn<QString>("language");
  for (const QString& language : ui::languagesOf(kSheets))
    QTest::newRow(qPrintable(language)) << language;
}

}  // namespace

class LessonSheetsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void isWrittenForEveryLesson_data() { addLanguageRows(); }
  void isWrittenForEveryLesson();
  void hasThePartsOfTheEnglishOne_data() { addLanguageRows(); }
  void hasThePartsOfTheEnglishOne();
  void quotesWhatTheProgramGives_data() { addLanguageRows(); }
  void quotesWhatTheProgramGives();
  void namesKeysThatExist_data() { addLanguageRows(); }
  void namesKeysThatExist();
  void namesWhatTheWindowSays_data() { addLanguageRows(); }
  void namesWhatTheWindowSays();
  void comesInTheLanguageOfTheWindowElseInEnglish();

 private:
  QTemporaryDir m_folder;
};

void LessonSheetsTest::initTestCase() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
  QVERIFY(ui::languagesOf(kSheets).contains(kEnglish));
}

void LessonSheetsTest::isWrittenForEveryLesson() {
  QFETCH(QString, language);
  const Speaking speaking(language);
  for (const ui::Lesson& lesson : ui::lessons()) {
    const QString text = sheet(lesson.name, language);
    QVERIFY2(!text.isEmpty(), qPrintable(lesson.name));
    if (speaking.isKnown()) QCOMPARE(text.section('\n', 0, 0), QStringLiteral("# ") + lesson.title);
  }
}

void LessonSheetsTest::hasThePartsOfTheEnglishOne() {
  QFETCH(QString, language);
  for (const ui::Lesson& lesson : ui::lessons()) {
    const QStringList parts = partsOf(sheet(lesson.name, language));
    const QStringList english = partsOf(sheet(lesson.name, kEnglish));
    QVERIFY2(parts.size() == kParts + 1, qPrintable(lesson.name));
    for (int part = 0; part <= kParts; ++part)
      QVERIFY2(itemsIn(parts[part]) == itemsIn(english[part]), qPrintable(lesson.name));
    QVERIFY(itemsIn(parts[3]) >= 3 && itemsIn(parts[4]) >= 3 && itemsIn(parts[5]) >= 3);
  }
}

void LessonSheetsTest::quotesWhatTheProgramGives() {
  QFETCH(QString, language);
  const Speaking speaking(language);
  QStringList wrong;
  for (const ui::Lesson& lesson : ui::lessons()) {
    const QStringList quoted = numbersIn(partsOf(sheet(lesson.name, language)).value(kSeen + 1));
    QStringList given;
    for (const LessonFigure& figure : figuresOf(lesson.name)) {
      given << (figure.text() + ' ' + figure.unit).trimmed();
      if (!quoted.contains(given.last()))
        wrong << QStringLiteral("%1 does not say %2 (%3)")
                     .arg(lesson.name, given.last(), figure.what);
    }
    for (const QString& number : quoted)
      if (!given.contains(number) && !countsWeights(number))
        wrong << QStringLiteral("%1 says %2, which nothing gives").arg(lesson.name, number);
  }
  QVERIFY2(wrong.isEmpty(), qPrintable('\n' + wrong.join('\n')));
}

void LessonSheetsTest::namesKeysThatExist() {
  QFETCH(QString, language);
  const Speaking speaking(language);
  const QStringList keys = keyNames();
  const QString lessons =
      ui::Commands().action(ui::Command::kLessons)->shortcut().toString(QKeySequence::NativeText);
  for (const auto& [name, text] : textsIn(language)) {
    const QStringList named = between(QStringLiteral("`"), text);
    QVERIFY2(named.contains(lessons), qPrintable(name));
    for (const QString& key : named)
      QVERIFY2(keys.contains(key), qPrintable(name + QStringLiteral(": ") + key));
  }
}

void LessonSheetsTest::namesWhatTheWindowSays() {
  QFETCH(QString, language);
  const Speaking speaking(language);
  if (!speaking.isKnown()) return;  // its window speaks English
  const ui::MainWindow window(ui::builtInScene(QStringLiteral("seven-weights")));
  const QStringList words = wordsOf(window);
  for (const auto& [name, text] : textsIn(language)) {
    QStringList named = between(QStringLiteral("*"), text);
    for (const QString& path : between(QStringLiteral("**"), text))
      named << path.split(QStringLiteral(" ▸ "));
    for (QString& part : named)
      QVERIFY2(words.contains(part.remove(QStringLiteral("…"))),
               qPrintable(name + QStringLiteral(": ") + part));
  }
}

void LessonSheetsTest::comesInTheLanguageOfTheWindowElseInEnglish() {
  const QString name = QStringLiteral("pile");
  QLocale::setDefault(QLocale(QLocale::Icelandic));
  QCOMPARE(ui::longText(kSheets, name), sheet(name, kEnglish));
  for (const QString& language : ui::languagesOf(kSheets)) {
    QLocale::setDefault(QLocale(language));
    QCOMPARE(ui::longText(kSheets, name), sheet(name, language));
  }
  QLocale::setDefault(QLocale::c());
}

QTEST_MAIN(LessonSheetsTest)
#include "lesson_sheets_test.moc"
