// What the window does with files that are no scenes, with large ones, and with settings that are
// damaged or cannot be written. Nothing here depends on permissions: root has them all.

#include <algorithm>
#include <functional>
#include <sys/stat.h>
#include <utility>

#include <QLocale>
#include <QProgressBar>
#include <QProgressDialog>
#include <QPushButton>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/faulty_surroundings.h"
#include "tests/support/crowded_file.h"
#include "ui/control/first_scene.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/control/settings.h"
#include "ui/files/scene_file.h"

using ui::MainWindow;

namespace {

QByteArray noise(int size, quint32 seed) {
  QRandomGenerator random(seed);
  QByteArray bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random.bounded(256));
  return bytes;
}

/// Hands over the dialog of a file that is opened when it is shown, before it shows any progress.
class OpeningWatch : public QObject {
 public:
  explicit OpeningWatch(std::function<void(const QProgressDialog&)> use) : m_use(std::move(use)) {
    qApp->installEventFilter(this);
  }

 private:
  bool eventFilter(QObject* object, QEvent* event) override {
    const auto* dialog = qobject_cast<QProgressDialog*>(object);
    if (dialog && event->type() == QEvent::Show) m_use(*dialog);
    return false;
  }

  std::function<void(const QProgressDialog&)> m_use;
};

}  // namespace

class FaultyInputTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void refusesWhatIsNoSceneFile_data();
  void refusesWhatIsNoSceneFile();
  void opensAByteOrderMarkAndALongLine();
  void staysWithTheDemonstrationWhereTheLastSceneIsAPipe();
  void showsHowFarALargeFileIs();
  void givesUpALargeFile();

  void saysThatSettingsAreNotRemembered_data();
  void saysThatSettingsAreNotRemembered();
  void startsWithDamagedSettings_data();
  void startsWithDamagedSettings();
  void mendsDamagedSettings();
  void doesNotWaitForTheDead_data();
  void doesNotWaitForTheDead();

 private:
  QString path(const QString& name) const { return m_folder->filePath(name); }
  QString settingsFile() const { return path("config/angrycuts/angrycuts.conf"); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void FaultyInputTest::init() {
  QLocale::setDefault(QLocale::c());
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("config"));
}

void FaultyInputTest::refusesWhatIsNoSceneFile_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("reason");
  const auto row = [](const char* what, const char* file, const char* reason) {
    QTest::newRow(what) << QString(file) << QString(reason);
  };
  row("folder", ".", "file to open is a directory");
  row("pipe", "pipe", "it is no file but a pipe or a device");
  row("device", "/dev/zero", "it is no file but a pipe or a device");
  row("device that fails", "/proc/self/mem", "Input/output error");
  row("empty", "empty.json", "the file is empty");
  row("white space", "space.json",
      "not JSON: line 2, column 1: the text ends where a value must stand");
  row("UTF-16", "utf16.json", "not UTF-8 but UTF-16; save it as UTF-8");
  row("UTF-16, other order", "utf16be.json", "not UTF-8 but UTF-16; save it as UTF-8");
  row("Latin-1", "latin1.json", "not UTF-8");
  row("line of a megabyte", "long.json", "weights[20000]: must be an object, got a number");
  row("text of a megabyte", "text.json",
      "format: must be \"angry-cuts/scene\", got \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx…\"");
  row("no such file", "none.json", "No such file or directory");
  row("link in a circle", "circle.json", "No such file or directory|Too many levels.*");
}

void FaultyInputTest::refusesWhatIsNoSceneFile() {
  QFETCH(QString, file);
  QFETCH(QString, reason);
  QCOMPARE(mkfifo(qPrintable(path("pipe")), 0600), 0);
  QVERIFY(QFile::link("circle.json", path("circle.json")));
  write(path("empty.json"), {});
  write(path("space.json"), " \n");
  write(path("utf16.json"), QByteArray("\xFF\xFE{\0}\0", 6));
  write(path("utf16be.json"), QByteArray("\xFE\xFF\0{\0}", 6));
  write(path("latin1.json"), "{\"name\": \"Tv\xE5\"}");
  write(path("long.json"), oneLineOf(20'000, "1"));
  write(path("text.json"), R"({"format": ")" + QByteArray(1 << 20, 'x') + "\", \"version\": 1}");

  MainWindow window(threeWeights());
  const Messages messages;
  window.files()->open(QDir(m_folder->path()).filePath(file));
  QCOMPARE(messages.texts.size(), 1);
  const QString expected =
      QFileInfo(QDir(m_folder->path()).filePath(file)).fileName() + " was not opened:\n";
  QVERIFY(messages.texts.first().startsWith(expected));
  const QString said = messages.texts.first().mid(expected.size());
  const bool isSaid =
      said == reason ||
      QRegularExpression(QRegularExpression::anchoredPattern(reason)).match(said).hasMatch();
  QVERIFY2(isSaid, qPrintable(said));
  QCOMPARE(window.editor()->scene()->name, std::string("Three"));
  verifyAlive(window);
}

void FaultyInputTest::opensAByteOrderMarkAndALongLine() {
  write(path("mark.json"), "\xEF\xBB\xBF" + ui::sceneText(threeWeights()));
  write(path("long.json"), oneLineOf(20'000));
  QVERIFY(contentOf(path("long.json")).size() > 1 << 20);
  QCOMPARE(contentOf(path("long.json")).count('\n'), 0);
  MainWindow window(core::withWeightCount(threeWeights(), 1));
  const Messages messages;
  window.files()->open(path("mark.json"));
  QCOMPARE(window.editor()->scene()->weights.size(), std::size_t{3});
  window.files()->open(path("long.json"));
  QCOMPARE(window.editor()->scene()->weights.size(), std::size_t{20'000});
  QCOMPARE(messages.texts, QStringList());
}

void FaultyInputTest::staysWithTheDemonstrationWhereTheLastSceneIsAPipe() {
  QCOMPARE(mkfifo(qPrintable(path("pipe")), 0600), 0);
  ui::Settings().setLastScene(path("pipe"));
  const ui::FirstScene first = ui::firstScene({});
  QCOMPARE(first.scene->name, ui::builtInScene(ui::kDemonstration).name);
  QVERIFY2(first.message.contains("pipe or a device"), qPrintable(first.message));
}

void FaultyInputTest::showsHowFarALargeFileIs() {
  write(path("crowd.json"), oneLineOf(20'000));
  MainWindow window(threeWeights());
  window.show();
  QList<int> shown;
  QString words;
  const OpeningWatch watch([&](const QProgressDialog& dialog) {
    words = dialog.labelText();
    connect(dialog.findChild<QProgressBar*>(), &QProgressBar::valueChanged, this,
            [&shown](int percent) { shown << percent; });
  });
  window.files()->open(path("crowd.json"));
  QCOMPARE(window.editor()->scene()->weights.size(), std::size_t{20'000});
  QCOMPARE(words, QString("Opening crowd.json…"));
  QVERIFY2(shown.size() > 3, qPrintable(QString::number(shown.size())));
  QVERIFY(std::is_sorted(shown.begin(), shown.end()));
  QVERIFY(window.findChildren<QProgressDialog*>().isEmpty());
}

void FaultyInputTest::givesUpALargeFile() {
  write(path("crowd.json"), oneLineOf(20'000));
  MainWindow window(threeWeights());
  window.show();
  const Messages messages;
  const OpeningWatch watch([](const QProgressDialog& dialog) {
    connect(dialog.findChild<QProgressBar*>(), &QProgressBar::valueChanged,
            dialog.findChild<QPushButton*>(), &QPushButton::click, Qt::SingleShotConnection);
  });
  window.files()->open(path("crowd.json"));
  QCOMPARE(window.editor()->scene()->weights.size(), std::size_t{3});
  QCOMPARE(messages.texts, QStringList());
  verifyAlive(window);
}

void FaultyInputTest::saysThatSettingsAreNotRemembered_data() {
  QTest::addColumn<QString>("folder");
  QTest::newRow("read-only") << kReadOnlyFolder;
  QTest::newRow("a file is in the way") << "taken";
}

void FaultyInputTest::saysThatSettingsAreNotRemembered() {
  QFETCH(QString, folder);
  write(path("taken"), "a file");
  const QString place = QDir(m_folder->path()).filePath(folder);
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, place);
  const ui::FirstScene first = ui::firstScene({});
  QCOMPARE(first.message, QString("Settings are not remembered: nothing can be written to %1")
                              .arg(place + "/angrycuts/angrycuts.conf"));
  MainWindow window(*first.scene, first.file);
  window.show();
  verifyAlive(window);
  QVERIFY(window.files()->saveTo(path("still.json")));
  QVERIFY(window.close());
}

void FaultyInputTest::startsWithDamagedSettings_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::newRow("empty") << QByteArray();
  QTest::newRow("one zero byte") << QByteArray(1, '\0');
  for (quint32 seed = 1; seed <= 5; ++seed) {
    QTest::addRow("noise %u", seed) << noise(2000, seed);
    const QByteArray bytes = "@ByteArray(" + noise(300, seed).toPercentEncoding() + ')';
    QTest::addRow("nonsense in every key %u", seed)
        << "[General]\ngeometry=" + bytes + "\npanels=" + bytes +
               "\nspeed=@Invalid()\nchartSize=@Size(-1 0)\ntheme=@Variant(" +
               noise(20, seed).toPercentEncoding() +
               ")\nrecentFiles=1, 2, \"\nlastScene=@@\nchartKind=%\npainter=\\x\ntextSize=9e99\n" +
               "[switches]\ntrails=perhaps\n";
  }
  QTest::newRow("line of a megabyte") << "[General]\nspeed=" + QByteArray(1 << 20, '9');
  QTest::newRow("bracket left open") << QByteArray("[General\ntrails=2\n");
}

void FaultyInputTest::startsWithDamagedSettings() {
  QFETCH(QByteArray, content);
  QVERIFY(QDir().mkpath(path("config/angrycuts")));
  write(settingsFile(), content);
  {
    const ui::FirstScene first = ui::firstScene({});
    QVERIFY(first.scene);
    MainWindow window(*first.scene, first.file);
    window.show();
    verifyAlive(window);
    QCOMPARE(window.controller()->speed(), 1.0);
    QVERIFY(window.width() > 300 && window.height() > 200);
    window.controller()->setSpeed(0.5);
    QVERIFY(window.close());
  }
  QSettings mended(settingsFile(), QSettings::IniFormat);
  QCOMPARE(mended.status(), QSettings::NoError);
  QCOMPARE(mended.value("speed").toDouble(), 0.5);
}

void FaultyInputTest::mendsDamagedSettings() {
  QVERIFY(QDir().mkpath(path("config/angrycuts")));
  write(settingsFile(), "speed=2\nsomething else\ntheme=dark\n");
  const ui::FirstScene first = ui::firstScene({});
  QCOMPARE(first.message,
           QString("The settings in %1 were damaged; what could not be read is as at first.")
               .arg(settingsFile()));
  QCOMPARE(ui::Settings().theme(), ui::ThemeChoice::kDark);  // what can be read is kept
  { MainWindow window(*first.scene, first.file); }
  QCOMPARE(ui::firstScene({}).message, QString());
  QCOMPARE(ui::Settings().theme(), ui::ThemeChoice::kDark);
}

void FaultyInputTest::doesNotWaitForTheDead_data() {
  QTest::addColumn<QByteArray>("lock");
  QTest::newRow("killed before it could say who it is") << QByteArray();
  QTest::newRow("this computer had another name")
      << QByteArray("1\nangrycuts\nelsewhere\nid\nid\n");
}

void FaultyInputTest::doesNotWaitForTheDead() {
  QFETCH(QByteArray, lock);
  QVERIFY(QDir().mkpath(path("config/angrycuts")));
  write(settingsFile() + ".lock", lock);
  ui::Settings settings;
  // Before anything is written: for that Qt would wait half a minute.
  QVERIFY(!QFile::exists(settingsFile() + ".lock"));
  settings.setSpeed(2);
  QCOMPARE(settings.speed(), 2.0);
}

QTEST_MAIN(FaultyInputTest)
#include "faulty_input_test.moc"
