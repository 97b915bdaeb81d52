#include <QDirIterator>
#include <QImage>
#include <QMimeDatabase>
#include <QStandardPaths>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/support/outcome.h"
#include "tests/support/translated_languages.h"

using tests::Outcome;
using tests::outcomeOf;

namespace {

const QString kSceneType = "application/x-angrycuts-scene";

const QList<int> kIconSizes{16, 22, 24, 32, 48, 64, 128, 256, 512};

// A scene as a person may write it: the mark is not the first key.
const QByteArray kScene = R"(
{
  "name": "By hand",
  "format": "angry-cuts/scene", "version": 1,
  "weights": []
}
)";

/// Everything below a folder that is no folder, in order.
QStringList filesIn(const QString& folder) {
  QStringList files;
  QDirIterator all(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (all.hasNext()) files.append(QDir(folder).relativeFilePath(all.next()));
  files.sort();
  return files;
}

QStringList expectedFiles() {
  QStringList files{"bin/angrycuts",
                    "share/applications/angrycuts.desktop",
                    "share/bash-completion/completions/angrycuts",
                    "share/doc/angrycuts/changelog.gz",
                    "share/doc/angrycuts/copyright",
                    "share/fish/vendor_completions.d/angrycuts.fish",
                    "share/icons/hicolor/scalable/apps/angrycuts.svg",
                    "share/man/man1/angrycuts.1.gz",
                    "share/metainfo/org.angrycuts.angrycuts.metainfo.xml",
                    "share/mime/packages/angrycuts.xml",
                    "share/zsh/vendor-completions/_angrycuts"};
  for (const int size : kIconSizes) {
    files.append(QStringLiteral("share/icons/hicolor/%1x%1/apps/angrycuts.png").arg(size));
  }
  files.sort();
  return files;
}

QStringList translatedLanguages() {
  return tests::translatedLanguages(QDir(ANGRYCUTS_TRANSLATIONS));
}

/// The texts of all elements of that name, by their languages; English ones have none.
QMap<QString, QStringList> textsIn(const QByteArray& xml, const QString& element) {
  QMap<QString, QStringList> texts;
  QXmlStreamReader reader(xml);
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement || reader.name() != element) continue;
    const QString language = reader.attributes().value("xml:lang").toString();
    texts[language] << reader.readElementText().simplified();
  }
  return texts;
}

bool isInstalled(const char* tool) {
  return !QStandardPaths::findExecutable(tool).isEmpty();
}

}  // namespace

/// Installs the program once, and looks at what came of it as a desktop would.
class InstallationTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();

  void holdsWhatItShouldAndNothingElse();
  void runsFromWhereItWasInstalled();
  void drawsTheIconInEverySize();
  void saysTheVersionOfTheProject();

  void menuEntryIsValid();
  void metainfoIsValid();
  void menuEntrySpeaksEveryLanguage();
  void metainfoAndKindOfFileSpeakEveryLanguage_data();
  void metainfoAndKindOfFileSpeakEveryLanguage();
  void manualIsValid();
  void manualNamesWhatHelpNames();
  void recognizesScenes_data();
  void recognizesScenes();
  void packageHoldsWhatIsInstalled();

 private:
  QString path(const QString& file) const { return m_prefix.filePath(file); }
  QByteArray content(const QString& file) const;
  QByteArray manual() const;

  QTemporaryDir m_prefix;
};

void InstallationTest::initTestCase() {
  const Outcome installed =
      outcomeOf(ANGRYCUTS_CMAKE, {"--install", ANGRYCUTS_BUILD, "--prefix", m_prefix.path()});
  QVERIFY2(installed.status == 0, installed.error);
}

QByteArray InstallationTest::content(const QString& file) const {
  QFile input(path(file));
  return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
}

/// The manual page's source.
QByteArray InstallationTest::manual() const {
  return outcomeOf("gzip", {"--decompress", "--stdout", path("share/man/man1/angrycuts.1.gz")})
      .output;
}

void InstallationTest::holdsWhatItShouldAndNothingElse() {
  QCOMPARE(filesIn(m_prefix.path()).join('\n'), expectedFiles().join('\n'));
}

void InstallationTest::runsFromWhereItWasInstalled() {
  const QString program = path("bin/angrycuts");
  QCOMPARE(outcomeOf(program, {"--version"}).output, "angrycuts " ANGRYCUTS_VERSION "\n");
  QVERIFY(outcomeOf(program, {"scenes"}).output.contains("\nseven-weights\t"));
  const Outcome run =
      outcomeOf(program, {"simulate", "seven-weights", "--until", "2", "--events", "-"});
  QCOMPARE(run.status, 0);
  QCOMPARE(run.error, QByteArray());
  QVERIFY(run.output.contains(",cut,"));
}

void InstallationTest::drawsTheIconInEverySize() {
  for (const int size : kIconSizes) {
    const QImage icon(
        path(QStringLiteral("share/icons/hicolor/%1x%1/apps/angrycuts.png").arg(size)));
    QCOMPARE(icon.size(), QSize(size, size));
    QCOMPARE(icon.pixelColor(0, 0).alpha(), 0);  // beside a round corner
    // Inside the yellow weight, a blue one, and the ground between them.
    QCOMPARE(icon.pixelColor(size * 12 / 64, size * 41 / 64), QColor("#e69f00"));
    QCOMPARE(icon.pixelColor(size * 44 / 64, size * 47 / 64), QColor("#56b4e9"));
    QCOMPARE(icon.pixelColor(size * 28 / 64, size * 56 / 64), QColor("#1e2f45"));
  }
}

void InstallationTest::saysTheVersionOfTheProject() {
  QVERIFY(content("share/metainfo/org.angrycuts.angrycuts.metainfo.xml")
              .contains("<release version=\"" ANGRYCUTS_VERSION "\" date=\"20"));
  QVERIFY(manual().contains("\"Angry Cuts " ANGRYCUTS_VERSION "\""));
}

void InstallationTest::menuEntryIsValid() {
  if (!isInstalled("desktop-file-validate")) QSKIP("desktop-file-utils is not installed");
  const Outcome verdict =
      outcomeOf("desktop-file-validate", {path("share/applications/angrycuts.desktop")});
  QCOMPARE(verdict.output + verdict.error, QByteArray());
  QCOMPARE(verdict.status, 0);
  QVERIFY(content("share/applications/angrycuts.desktop")
              .contains("\nMimeType=" + kSceneType.toUtf8() + ";\n"));
}

void InstallationTest::metainfoIsValid() {
  if (!isInstalled("appstreamcli")) QSKIP("appstream is not installed");
  const Outcome verdict =
      outcomeOf("appstreamcli", {"validate", "--no-net", "--pedantic", "--no-color",
                                 path("share/metainfo/org.angrycuts.angrycuts.metainfo.xml")});
  QVERIFY2(verdict.status == 0, verdict.output);
  QVERIFY2(verdict.output.endsWith("Validation was successful.\n"), verdict.output);
}

void InstallationTest::menuEntrySpeaksEveryLanguage() {
  const QString entry = content("share/applications/angrycuts.desktop");
  const auto valueOf = [&entry](const QString& key) {
    return entry.section('\n' + key + '=', 1, 1).section('\n', 0, 0);
  };
  QVERIFY(translatedLanguages().size() >= 4);
  for (const QString key : {"GenericName", "Comment", "Keywords"}) {
    QVERIFY(!valueOf(key).isEmpty());
    for (const QString& language : translatedLanguages()) {
      const QString name = QStringLiteral("%1[%2]").arg(key, language);
      QVERIFY2(!valueOf(name).isEmpty() && valueOf(name) != valueOf(key), qPrintable(name));
    }
  }
}

void InstallationTest::metainfoAndKindOfFileSpeakEveryLanguage_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("element");
  const QString metainfo = "share/metainfo/org.angrycuts.angrycuts.metainfo.xml";
  QTest::newRow("summary") << metainfo << "summary";
  QTest::newRow("paragraphs") << metainfo << "p";
  QTest::newRow("items") << metainfo << "li";
  QTest::newRow("kind of file") << "share/mime/packages/angrycuts.xml"
                                << "comment";
}

void InstallationTest::metainfoAndKindOfFileSpeakEveryLanguage() {
  QFETCH(QString, file);
  QFETCH(QString, element);
  const QMap<QString, QStringList> texts = textsIn(content(file), element);
  const QStringList english = texts.value({});
  QVERIFY(!english.isEmpty());
  for (const QString& language : translatedLanguages()) {
    const QStringList translated = texts.value(language);
    QVERIFY2(translated.size() == english.size(), qPrintable(language));
    for (const QString& text : translated)
      QVERIFY2(!text.isEmpty() && !english.contains(text), qPrintable(language + ": " + text));
  }
}

void InstallationTest::manualIsValid() {
  if (!isInstalled("groff")) QSKIP("groff-base is not installed");
  QFile page(path("angrycuts.1"));
  QVERIFY(page.open(QIODevice::WriteOnly) && page.write(manual()) > 0 && page.flush());
  const Outcome verdict = outcomeOf("groff", {"-man", "-ww", "-Tutf8", page.fileName()});
  page.remove();
  QCOMPARE(verdict.error, QByteArray());
  QCOMPARE(verdict.status, 0);
  QVERIFY(verdict.output.contains("ANGRYCUTS(1)"));
}

void InstallationTest::manualNamesWhatHelpNames() {
  static const QRegularExpression kOption("--[a-z]+");
  const QString help = outcomeOf(path("bin/angrycuts"), {"--help"}).output;
  const QString page = QString::fromUtf8(manual()).replace("\\-", "-");
  QSet<QString> named;
  for (auto match = kOption.globalMatch(page); match.hasNext();) named << match.next().captured();
  QSet<QString> offered;
  for (auto match = kOption.globalMatch(help); match.hasNext();) offered << match.next().captured();
  QVERIFY(offered.contains("--trajectory"));
  QCOMPARE(named, offered);
}

void InstallationTest::recognizesScenes_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("type");
  QTest::newRow("by its ending") << "lesson.angrycuts.json" << kScene << kSceneType;
  QTest::newRow("by what stands in it") << "lesson" << kScene << kSceneType;
  // A plain .json says nothing: guessing would touch every other program's files.
  QTest::newRow("not by .json") << "lesson.json" << kScene << "application/json";
  QTest::newRow("other JSON") << "package.json" << QByteArray("{\"name\": 1}")
                              << "application/json";
  QTest::newRow("words about scenes")
      << "notes" << QByteArray("Begin a scene with \"angry-cuts/scene\".\n") << "text/plain";
}

void InstallationTest::recognizesScenes() {
  if (!isInstalled("update-mime-database")) QSKIP("shared-mime-info is not installed");
  QFETCH(QString, file);
  QFETCH(QByteArray, text);
  QFETCH(QString, type);
  const QByteArray folders = path("share").toUtf8() + ":/usr/local/share:/usr/share";
  qputenv("XDG_DATA_DIRS", folders);
  const Outcome update = outcomeOf("update-mime-database", {path("share/mime")});
  QCOMPARE(update.error, QByteArray());
  QCOMPARE(update.status, 0);

  QTemporaryDir folder;
  QFile scene(folder.filePath(file));
  QVERIFY(scene.open(QIODevice::WriteOnly) && scene.write(text) > 0);
  scene.close();
  QCOMPARE(QMimeDatabase().mimeTypeForFile(scene.fileName()).name(), type);
}

void InstallationTest::packageHoldsWhatIsInstalled() {
  for (const char* tool : {"cpack", "dpkg-deb", "dpkg-shlibdeps", "file"}) {
    if (!isInstalled(tool)) QSKIP("cpack, dpkg-dev or file is not installed");
  }
  QTemporaryDir folder;
  const Outcome packing = outcomeOf("cpack", {"--config", ANGRYCUTS_BUILD "/CPackConfig.cmake",
                                              "-D", "CPACK_PACKAGE_DIRECTORY=" + folder.path()});
  QVERIFY2(packing.status == 0, packing.output + packing.error);
  const QStringList packages = QDir(folder.path()).entryList({"angrycuts_*.deb"});
  QCOMPARE(packages.size(), 1);

  const QString package = folder.filePath(packages.first());
  QCOMPARE(outcomeOf("dpkg-deb", {"--field", package, "Version"}).output, ANGRYCUTS_VERSION "\n");
  const QByteArray needs = outcomeOf("dpkg-deb", {"--field", package, "Depends"}).output;
  for (const char* library : {"libqt6widgets6", "libqt6charts6", "libqt6svg6", "libc6"}) {
    QVERIFY2(needs.contains(library), needs);
  }
  QCOMPARE(outcomeOf("dpkg-deb", {"--extract", package, folder.filePath("root")}).status, 0);
  QCOMPARE(filesIn(folder.filePath("root/usr")).join('\n'), expectedFiles().join('\n'));
}

QTEST_GUILESS_MAIN(InstallationTest)
#include "installation_test.moc"
