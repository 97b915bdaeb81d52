#include "ui/control/settings.h"

#include <QTemporaryDir>
#include <QTest>

class SettingsTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void startsWithDefaults();
  void remembersChoices();
  void readsNonsenseAsTheDefault();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void SettingsTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
}

void SettingsTest::startsWithDefaults() {
  QCOMPARE(ui::Settings().painter(), ui::PainterChoice::kAutomatic);
  QCOMPARE(ui::Settings().theme(), ui::ThemeChoice::kDesktop);
  QCOMPARE(ui::Settings().speed(), 1.0);
  QVERIFY(ui::Settings().isOn("trails", true));
  QVERIFY(!ui::Settings().isOn("splitViews", false));
  QCOMPARE(ui::Settings().recentFiles(), QStringList());
}

void SettingsTest::remembersChoices() {
  ui::Settings().setSpeed(0.25);
  ui::Settings().setOn("trails", false);
  ui::Settings().setRecentFiles({"/a b.json", "/c,d.json"});
  QCOMPARE(ui::Settings().speed(), 0.25);
  QVERIFY(!ui::Settings().isOn("trails", true));
  QCOMPARE(ui::Settings().recentFiles(), QStringList({"/a b.json", "/c,d.json"}));
  ui::Settings().setPainter(ui::PainterChoice::kQPainter);
  ui::Settings().setTheme(ui::ThemeChoice::kDark);
  QCOMPARE(ui::Settings().painter(), ui::PainterChoice::kQPainter);
  QCOMPARE(ui::Settings().theme(), ui::ThemeChoice::kDark);
}

void SettingsTest::readsNonsenseAsTheDefault() {
  QSettings store("angrycuts", "angrycuts");
  store.setValue("painter", QByteArray("\0\xff", 2));
  store.setValue("theme", 17);
  store.setValue("speed", "nan");
  QCOMPARE(ui::Settings().painter(), ui::PainterChoice::kAutomatic);
  QCOMPARE(ui::Settings().theme(), ui::ThemeChoice::kDesktop);
  QCOMPARE(ui::Settings().speed(), 1.0);
}

QTEST_MAIN(SettingsTest)
#include "settings_test.moc"
