// The files of translations hold what the program says: all of it, and nothing else.
#include <algorithm>
#include <vector>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/support/translated_languages.h"

namespace {

const QString kProject = QStringLiteral(ANGRYCUTS_PROJECT_DIR);

/// One text in a file of translations.
struct Message {
  QString context;
  QString source;
  QStringList translations;  ///< several for a text that counts
  QString type;              ///< "unfinished", "vanished", "obsolete", or empty
};

QString fileOf(const QString& language) {
  return kProject + QStringLiteral("/translations/angrycuts_%1.ts").arg(language);
}

std::vector<Message> messagesIn(const QString& fileName) {
  QFile file(fileName);
  if (!file.open(QIODevice::ReadOnly)) return {};
  std::vector<Message> messages;
  QString context;
  QXmlStreamReader reader(&file);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = reader.name();
    if (name == u"name") context = reader.readElementText();
    if (name == u"message") messages.push_back({context, {}, {}, {}});
    if (name == u"source") messages.back().source = reader.readElementText();
    if (name == u"numerusform") messages.back().translations << reader.readElementText();
    if (name == u"translation") {
      messages.back().type = reader.attributes().value("type").toString();
      const QString text = reader.readElementText(QXmlStreamReader::IncludeChildElements);
      if (!text.trimmed().isEmpty()) messages.back().translations << text;
    }
  }
  return messages;
}

QString described(const Message& message) {
  return QStringLiteral("%1: “%2” → “%3” %4")
      .arg(message.context, message.source, message.translations.join(" / "), message.type);
}

/// What must be in a translation as in its source: places for numbers and names.
QStringList placesIn(const QString& text) {
  static const QRegularExpression kPattern(QStringLiteral("%(?:\\d|n)"));
  QStringList places;
  for (const auto& match : kPattern.globalMatch(text)) places << match.captured();
  places.removeDuplicates();
  places.sort();
  return places;
}

/// Marks of the keys that choose menu entries and fields.
int keyMarksIn(QString text) {
  static const QRegularExpression kMark(QStringLiteral("&[^&\\s]"));
  return static_cast<int>(text.remove("&&").count(kMark));
}

void addLanguages() {
  QTest::addColumn<QString>("language");
  for (const QString& language : tests::translatedLanguages(kProject + "/translations"))
    QTest::newRow(qPrintable(language)) << language;
}

}  // namespace

class TranslationFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void holdsWhatTheProgramSays_data();
  void holdsWhatTheProgramSays();
  void keepsPlacesForNumbersAndNames_data() { addLanguages(); }
  void keepsPlacesForNumbersAndNames();
  void keepsMarksOfKeys_data() { addLanguages(); }
  void keepsMarksOfKeys();
};

void TranslationFilesTest::holdsWhatTheProgramSays_data() {
  addLanguages();
  QTest::newRow("en") << "en";
}

void TranslationFilesTest::holdsWhatTheProgramSays() {
  QFETCH(QString, language);
  const QTemporaryDir folder;
  const QString fresh = folder.filePath(QStringLiteral("angrycuts_%1.ts").arg(language));
  QVERIFY(QFile::copy(fileOf(language), fresh));
  // As update_translations does, but what is not used any more is kept, and marked.
  QStringList arguments{"-silent", "app",        "ui",   "-extensions", "h,cpp", "-I",
                        ".",       "-locations", "none", "-ts",         fresh};
  if (language == "en") arguments.prepend("-pluralonly");
  QProcess lupdate;
  lupdate.setWorkingDirectory(kProject);
  lupdate.start(ANGRYCUTS_LUPDATE, arguments);
  QVERIFY(lupdate.waitForFinished());
  QCOMPARE(lupdate.exitCode(), 0);
  const std::vector<Message> messages = messagesIn(fresh);
  QVERIFY(language == "en" ? !messages.empty() : messages.size() > 900);
  QStringList faults;
  for (const Message& message : messages)
    if (!message.type.isEmpty() || message.translations.isEmpty()) faults << described(message);
  QVERIFY2(faults.isEmpty(), qPrintable("build the target update_translations, then translate\n" +
                                        faults.join('\n')));
}

void TranslationFilesTest::keepsPlacesForNumbersAndNames() {
  QFETCH(QString, language);
  QStringList faults;
  for (const Message& message : messagesIn(fileOf(language)))
    for (const QString& translation : message.translations)
      if (placesIn(translation) != placesIn(message.source)) faults << described(message);
  QVERIFY2(faults.isEmpty(), qPrintable('\n' + faults.join('\n')));
}

void TranslationFilesTest::keepsMarksOfKeys() {
  QFETCH(QString, language);
  QStringList faults;
  for (const Message& message : messagesIn(fileOf(language))) {
    // Of Qt's own some languages have none.
    if (message.context.startsWith('Q')) continue;
    for (const QString& translation : message.translations)
      if (keyMarksIn(translation) != keyMarksIn(message.source)) faults << described(message);
  }
  QVERIFY2(faults.isEmpty(), qPrintable('\n' + faults.join('\n')));
}

QTEST_GUILESS_MAIN(TranslationFilesTest)
#include "translation_files_test.moc"
