#include "ui/style/icons.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPalette>
#include <QTest>

#include "ui/style/palette.h"
#include "ui/style/theme.h"

class IconsTest : public QObject {
  Q_OBJECT

 private slots:
  void everyIconCanBeDrawn_data();
  void everyIconCanBeDrawn();
  void takesTheTextColorOfThePaletteInForce();
  void isPaleWhereItCannotBeUsed();
};

namespace {

/// The color of the bar in the pause sign, which covers the point.
QColor colorOfPause(const QIcon& pause, QIcon::Mode mode = QIcon::Normal) {
  return pause.pixmap(QSize(48, 48), 1, mode).toImage().pixelColor(16, 24);
}

}  // namespace

void IconsTest::everyIconCanBeDrawn_data() {
  QTest::addColumn<QString>("name");
  for (const QString& file : QDir(":/icons").entryList()) {
    QTest::newRow(qPrintable(file)) << file.section('.', 0, 0);
  }
}

void IconsTest::everyIconCanBeDrawn() {
  QFETCH(QString, name);
  const QImage picture = ui::icon(name).pixmap(QSize(32, 32), 1).toImage();
  QCOMPARE(picture.size(), QSize(32, 32));
  int drawn = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) drawn += picture.pixelColor(x, y).alpha() > 128 ? 1 : 0;
  }
  // More than specks, and no icon fills the square to its corners.
  QVERIFY2(drawn > 30 && drawn < 1024, qPrintable(QString::number(drawn)));
}

void IconsTest::takesTheTextColorOfThePaletteInForce() {
  const QIcon pause = ui::icon("pause");
  for (const ui::Theme& theme : {ui::Theme::light(), ui::Theme::darkTheme()}) {
    QApplication::setPalette(ui::paletteOf(theme));
    QCOMPARE(colorOfPause(pause), theme.text);
  }
}

void IconsTest::isPaleWhereItCannotBeUsed() {
  QApplication::setPalette(ui::paletteOf(ui::Theme::light()));
  const QColor pale = QApplication::palette().color(QPalette::Disabled, QPalette::ButtonText);
  QCOMPARE(colorOfPause(ui::icon("pause"), QIcon::Disabled), pale);
}

QTEST_MAIN(IconsTest)
#include "icons_test.moc"
