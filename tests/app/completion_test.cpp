#include <QRegularExpression>
#include <QStandardPaths>
#include <QtTest>

#include "tests/support/outcome.h"

using tests::Outcome;
using tests::outcomeOf;

namespace {

// How each shell is asked what it offers for the last of the words: first comes the
// completion's file, then the program and the words of the call. The answer has one offer a
// line. zsh has its plans printed instead, which it would carry out only while a person types.
const QMap<QString, QString> kQuestions{{"bash", R"(compopt() { :; }
                source "$0"
                COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
                _angrycuts "$1"
                printf '%s\n' "${COMPREPLY[@]}")"},
                                        {"zsh", R"(_arguments() {
                 print -rl -- "$@"
                 for plan in "$@"; do
                   if [[ $plan == ${words[CURRENT-1]}\[* ]]; then print -rl -- ${(s: :)${plan#*\(}%\)}; fi
                   if [[ $plan == :scene:* ]]; then ${plan#:scene:}; fi
                 done
               }
               _alternative() {
                 for plan in "$@"; do
                   case $plan in
                     *\)) print -rl -- ${(s: :)${plan#*\(}%\)} ;;
                     *:_angrycuts*) ${plan##*:} ;;
                   esac
                 done
               }
               service=$1 words=("$@") CURRENT=$#
               source "$0")"},
                                        {"fish", R"(source $argv[1]
                set -x PATH (dirname $argv[2]) $PATH
                complete -C "angrycuts "(string join " " -- $argv[3..]))"}};

/// The option, or the word that is offered, of a line.
QString offerIn(const QString& line) {
  static const QRegularExpression kEnd(R"([\t\[].*)");
  return QString(line).remove(kEnd);
}

QString words(const QSet<QString>& offers) {
  return QStringList(offers.begin(), offers.end()).join(' ');
}

}  // namespace

/// Asks each shell for what it offers and compares that with what the program itself names.
class CompletionTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void offersTheCommands_data() { addShells(); }
  void offersTheCommands();
  void offersTheOptionsOfEachCommand_data();
  void offersTheOptionsOfEachCommand();
  void offersTheMethods_data() { addShells(); }
  void offersTheMethods();
  void offersTheBuiltInScenes_data() { addShells(); }
  void offersTheBuiltInScenes();
  void bashUnderstandsAnEqualsSign();
  void bashOffersFilesThatFit();

 private:
  static void addShells();
  QSet<QString> offers(const QString& shell, const QStringList& words) const;
  QSet<QString> optionsOf(const QString& command) const;

  QString m_help;
};

void CompletionTest::initTestCase() {
  m_help = outcomeOf(ANGRYCUTS_PROGRAM, {"--help"}).output;
  QVERIFY(!m_help.isEmpty());
}

void CompletionTest::addShells() {
  QTest::addColumn<QString>("shell");
  for (auto row = kQuestions.keyBegin(); row != kQuestions.keyEnd(); ++row) {
    QTest::newRow(qPrintable(*row)) << *row;
  }
}

/// What a shell offers for the last word of a call.
QSet<QString> CompletionTest::offers(const QString& shell, const QStringList& words) const {
  QStringList arguments{"-c", kQuestions[shell], ANGRYCUTS_COMPLETIONS "/angrycuts." + shell,
                        ANGRYCUTS_PROGRAM};
  const Outcome answer = outcomeOf(shell, arguments + words);
  if (answer.status != 0 || !answer.error.isEmpty()) return {"failed: " + answer.error};
  QSet<QString> offers;
  for (const QString& line : QString(answer.output).split('\n', Qt::SkipEmptyParts)) {
    offers << offerIn(line);
  }
  return offers;
}

/// The options that the program's help names for a command; for "" those of none.
QSet<QString> CompletionTest::optionsOf(const QString& command) const {
  static const QRegularExpression kOption("--[a-z]+");
  const QRegularExpression section("Options of " + command + "\\b.*?\n(.*?)\nWith ",
                                   QRegularExpression::DotMatchesEverythingOption);
  const QRegularExpression usage("^  angrycuts " + command + ".*$",
                                 QRegularExpression::MultilineOption);
  const QString text = command.isEmpty() ? "--help, --version"
                                         : section.match(m_help).captured(1) +
                                               usage.match(m_help).captured() + " --help";
  QSet<QString> options;
  for (auto match = kOption.globalMatch(text); match.hasNext();) options << match.next().captured();
  return options;
}

void CompletionTest::offersTheCommands() {
  QFETCH(QString, shell);
  if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP("this shell is not installed");
  static const QRegularExpression kCommand("^  angrycuts ([a-z]+) ",
                                           QRegularExpression::MultilineOption);
  QSet<QString> commands;
  for (auto match = kCommand.globalMatch(m_help); match.hasNext();) {
    commands << match.next().captured(1);
  }
  QCOMPARE(commands.size(), 3);
  const QSet<QString> offered = offers(shell, {""});
  QVERIFY2(offered.contains(commands), qPrintable(words(offered)));
}

void CompletionTest::offersTheOptionsOfEachCommand_data() {
  QTest::addColumn<QString>("shell");
  QTest::addColumn<QString>("command");
  for (auto shell = kQuestions.keyBegin(); shell != kQuestions.keyEnd(); ++shell) {
    for (const char* command : {"", "scenes", "simulate", "measure"}) {
      QTest::addRow("%s: angrycuts %s", qPrintable(*shell), command) << *shell << command;
    }
  }
}

void CompletionTest::offersTheOptionsOfEachCommand() {
  QFETCH(QString, shell);
  QFETCH(QString, command);
  if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP("this shell is not installed");
  QStringList call{command, "--"};
  call.removeAll("");
  QSet<QString> offered;
  for (const QString& offer : offers(shell, call)) {
    if (offer.startsWith("--")) offered << offer;
  }
  const QSet<QString> expected = optionsOf(command);
  QVERIFY2(expected.size() >= 2, "the help was not understood");
  QVERIFY2(offered == expected, qPrintable(words(offered)));
}

void CompletionTest::offersTheMethods() {
  QFETCH(QString, shell);
  if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP("this shell is not installed");
  static const QRegularExpression kMethods("--method NAME +(.*) \\(");
  const QStringList methods = kMethods.match(m_help).captured(1).split(", ");
  QVERIFY(methods.contains("rk4"));
  QSet<QString> offered = offers(shell, {"simulate", "--method", ""});
  if (shell != "zsh") QCOMPARE(offered.size(), methods.size());
  QVERIFY2(offered.contains({methods.begin(), methods.end()}), qPrintable(words(offered)));
}

void CompletionTest::offersTheBuiltInScenes() {
  QFETCH(QString, shell);
  if (QStandardPaths::findExecutable(shell).isEmpty()) QSKIP("this shell is not installed");
  const QString list = outcomeOf(ANGRYCUTS_PROGRAM, {"scenes"}).output;
  QSet<QString> scenes;
  for (const QString& line : list.split('\n', Qt::SkipEmptyParts)) scenes << offerIn(line);
  QVERIFY(scenes.contains("seven-weights"));
  for (const QStringList& call : {QStringList{""}, {"simulate", ""}, {"measure", ""}}) {
    const QSet<QString> offered = offers(shell, call);
    QVERIFY2(offered.contains(scenes), qPrintable(words(offered)));
  }
}

void CompletionTest::bashUnderstandsAnEqualsSign() {
  QCOMPARE(offers("bash", {"simulate", "--method", "=", "r"}), QSet<QString>{"rk4"});
  QCOMPARE(offers("bash", {"simulate", "--cut", "="}), QSet<QString>{"never"});
}

void CompletionTest::bashOffersFilesThatFit() {
  QTemporaryDir folder;
  const QString start = folder.path() + "/";
  for (const char* name : {"a scene.json", "b.csv", "c.png"}) {
    QVERIFY(QFile(start + name).open(QIODevice::WriteOnly));
  }
  QVERIFY(QDir(start).mkdir("d"));
  using Names = QSet<QString>;
  QCOMPARE(offers("bash", {"simulate", start}), (Names{start + "a scene.json", start + "d"}));
  QCOMPARE(offers("bash", {"measure", "x", "--chart", start}),
           (Names{start + "c.png", start + "d"}));
  QCOMPARE(offers("bash", {"scenes", "--export", start}), Names{start + "d"});
}

QTEST_GUILESS_MAIN(CompletionTest)
#include "completion_test.moc"
