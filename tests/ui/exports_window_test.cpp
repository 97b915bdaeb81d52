// Drives the window as a person does who takes something out of it.
#include <cmath>

#include <QFile>
#include <QFileDialog>
#include <QImageReader>
#include <QLineEdit>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/support/answer.h"
#include "tests/support/shown_window.h"
#include "tests/support/swinging_scene.h"
#include "ui/control/exports.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"

using tests::Answer;
using tests::swingingScene;
using ui::MainWindow;

namespace {

/// Lets this much time pass, whatever the clock on the wall says.
void pass(MainWindow& window, double seconds) {
  // Nor does it matter how long the work for it takes.
  window.controller()->setStopwatch([] { return 0.0; });
  window.controller()->passTime(seconds);
}

}  // namespace

class ExportsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void exportsAChartOfTheRightSize();
  void exportsAPictureOfTheRightSize();
  void exportsTheLedger();
  void offersTheEndingOfTheChosenKind();
  void saysWhenAnExportFails();

 private:
  QString inFolder(const QString& name) const { return m_folder.filePath(name); }

  QTemporaryDir m_folder;
};

void ExportsWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void ExportsWindowTest::exportsAChartOfTheRightSize() {
  MainWindow window(swingingScene());
  window.controller()->play();
  pass(window, 0.1);
  const QString file = inFolder("chart.png");
  window.exports()->saveChart(file);
  QImageReader reader(file);
  const QImage picture = reader.read();
  QVERIFY2(!picture.isNull(), qPrintable(reader.errorString()));
  // 160 mm at 300 dpi, to the pixel.
  QVERIFY(std::abs(picture.width() - 160 / 25.4 * 300) <= 1);
  QVERIFY(std::abs(picture.dotsPerMeterX() - 300 / 0.0254) < 1);
}

void ExportsWindowTest::exportsAPictureOfTheRightSize() {
  MainWindow window(swingingScene());
  const QString file = inFolder("scene.png");
  window.exports()->savePicture(file);
  QCOMPARE(QImageReader(file).size(), QSize(2400, 1800));
}

void ExportsWindowTest::exportsTheLedger() {
  MainWindow window(swingingScene());
  window.controller()->play();
  pass(window, 0.1);
  const QString name = inFolder("ledger.csv");
  window.exports()->saveLedger(name, 1);
  QFile file(name);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QList<QByteArray> lines = file.readAll().split('\n');
  QCOMPARE(lines.first(), QByteArray("time,kinetic,potential,lost_to_air,lost_to_impacts,"
                                     "lost_to_ropes,lost_to_friction,numerical_drift\r"));
  QVERIFY(lines.size() > 5);
}

void ExportsWindowTest::offersTheEndingOfTheChosenKind() {
  MainWindow window(swingingScene());
  tests::showInFront(window);
  QTimer::singleShot(0, this, [this] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    QVERIFY(dialog);
    dialog->setDirectory(m_folder.path());
    dialog->findChild<QLineEdit*>()->setText("asked");
    QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
  });
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(QFile::exists(inFolder("asked.png")));
}

void ExportsWindowTest::saysWhenAnExportFails() {
  MainWindow window(swingingScene());
  Answer answer(QMessageBox::Ok);
  window.exports()->saveChart(inFolder("no/such/folder.png"));
  QVERIFY(answer.text.startsWith("folder.png was not written:"));
}

QTEST_MAIN(ExportsWindowTest)
#include "exports_window_test.moc"
