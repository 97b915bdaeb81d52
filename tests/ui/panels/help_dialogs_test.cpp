#include "ui/panels/help_dialogs.h"

#include <QApplication>
#include <QMessageBox>
#include <QTimer>
#include <QtTest>

class HelpDialogsTest : public QObject {
  Q_OBJECT

 private slots:
  void aboutBoxNamesTheVersionOfTheProject();
};

void HelpDialogsTest::aboutBoxNamesTheVersionOfTheProject() {
  QString words;
  QTimer::singleShot(0, this, [&words] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    words = box->text();
    box->close();
  });
  ui::showAbout(nullptr);
  QVERIFY2(words.contains("Angry Cuts " ANGRYCUTS_VERSION "<"), qPrintable(words));
}

QTEST_MAIN(HelpDialogsTest)
#include "help_dialogs_test.moc"
