#include "ui/files/output_file.h"

#include <sys/stat.h>

#include <QtTest>

#include "tests/support/file_content.h"
#include "tests/support/small_disk.h"

using tests::contentOf;

class OutputFileTest : public QObject {
  Q_OBJECT

 private slots:
  void standsThereOnlyOnceFinished();
  void keepsTheOldFileWhenDropped();
  void keepsTheOldFileWhenTheDiskIsFull_data();
  void keepsTheOldFileWhenTheDiskIsFull();
  void followsALinkToItsTarget();
  void saysWhyItCannotBeOpened();
  void writesIntoADeviceInsteadOfReplacingIt();
  void noticesAFullDevice();
};

void OutputFileTest::standsThereOnlyOnceFinished() {
  QTemporaryDir folder;
  const QString name = folder.filePath("rows.csv");
  ui::OutputFile file;
  QVERIFY(file.open(name));
  QVERIFY(file.write("a,b\r\n"));
  QVERIFY(file.write("1,2\r\n"));
  QVERIFY(!QFile::exists(name));
  QVERIFY(file.finish());
  QCOMPARE(contentOf(name), QByteArray("a,b\r\n1,2\r\n"));
  QCOMPARE(file.error(), QString());
}

void OutputFileTest::keepsTheOldFileWhenDropped() {
  QTemporaryDir folder;
  const QString name = folder.filePath("rows.csv");
  for (const bool isFinished : {true, false}) {
    ui::OutputFile file;
    QVERIFY(file.open(name));
    QVERIFY(file.write(isFinished ? "old" : "new"));
    if (isFinished) QVERIFY(file.finish());
  }
  QCOMPARE(contentOf(name), QByteArray("old"));
  QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"rows.csv"});
}

void OutputFileTest::keepsTheOldFileWhenTheDiskIsFull_data() {
  QTest::addColumn<int>("piece");  // [bytes]
  QTest::newRow("in one large piece") << 1'000'000;
  QTest::newRow("in small pieces") << 100;
}

void OutputFileTest::keepsTheOldFileWhenTheDiskIsFull() {
  QFETCH(int, piece);
  QTemporaryDir folder;
  const QString name = folder.filePath("rows.csv");
  QFile old(name);
  QVERIFY(old.open(QIODevice::WriteOnly));
  old.write("old");
  old.close();

  QString error;
  {
    const SmallDisk disk(10'000);
    ui::OutputFile file;
    QVERIFY(file.open(name));
    for (int i = 0; i < 1'000'000; i += piece) file.write(std::string(piece, 'x'));
    QVERIFY(!file.finish());
    error = file.error();
  }
  QCOMPARE(error, QString("File too large"));
  QCOMPARE(contentOf(name), QByteArray("old"));
  QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{"rows.csv"});
}

void OutputFileTest::followsALinkToItsTarget() {
  QTemporaryDir folder;
  const QString target = folder.filePath("target.csv");
  QFile(target).open(QIODevice::WriteOnly);
  const QString link = folder.filePath("link.csv");
  QVERIFY(QFile::link(target, link));
  ui::OutputFile file;
  QVERIFY(file.open(link) && file.write("new") && file.finish());
  QVERIFY(QFileInfo(link).isSymLink());
  QCOMPARE(contentOf(target), QByteArray("new"));
}

void OutputFileTest::saysWhyItCannotBeOpened() {
  QTemporaryDir folder;
  ui::OutputFile inNoFolder;
  QVERIFY(!inNoFolder.open(folder.filePath("none/rows.csv")));
  QCOMPARE(inNoFolder.error(), QString("No such file or directory"));
  ui::OutputFile isFolder;
  QVERIFY(!isFolder.open(folder.path()));
  QVERIFY(!isFolder.error().isEmpty());
}

void OutputFileTest::writesIntoADeviceInsteadOfReplacingIt() {
  QTemporaryDir folder;
  const QString pipe = folder.filePath("pipe");
  QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
  QFile reader(pipe);
  // Open at both ends, so that neither waits for the other.
  QVERIFY(reader.open(QIODevice::ReadWrite | QIODevice::Unbuffered));
  ui::OutputFile file;
  QVERIFY(file.open(pipe) && file.write("rows") && file.finish());
  QCOMPARE(reader.read(4), QByteArray("rows"));
  QVERIFY(!QFileInfo(pipe).isFile());
}

void OutputFileTest::noticesAFullDevice() {
  ui::OutputFile file;
  QVERIFY(file.open("/dev/full"));
  file.write("rows");
  QVERIFY(!file.finish());
  QCOMPARE(file.error(), QString("No space left on device"));
}

QTEST_GUILESS_MAIN(OutputFileTest)
#include "output_file_test.moc"
