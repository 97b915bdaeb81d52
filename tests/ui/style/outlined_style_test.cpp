#include "ui/style/outlined_style.h"

#include <QCheckBox>
#include <QStyleOptionButton>
#include <QTest>

#include "tests/support/contrast.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"

class OutlinedStyleTest : public QObject {
  Q_OBJECT

 private slots:
  void anEmptyBoxIsSeen_data();
  void anEmptyBoxIsSeen();
};

void OutlinedStyleTest::anEmptyBoxIsSeen_data() {
  QTest::addColumn<bool>("dark");
  QTest::newRow("light") << false;
  QTest::newRow("dark") << true;
}

void OutlinedStyleTest::anEmptyBoxIsSeen() {
  QFETCH(bool, dark);
  ui::OutlinedStyle style;
  QCheckBox box;
  box.setStyle(&style);
  box.setPalette(ui::paletteOf(dark ? ui::Theme::darkTheme() : ui::Theme::light()));
  box.resize(box.sizeHint());
  QStyleOptionButton option;
  option.initFrom(&box);
  const QRect place = style.subElementRect(QStyle::SE_CheckBoxIndicator, &option, &box);
  const QImage picture = box.grab().toImage();
  const QColor ground = box.palette().color(QPalette::Window);
  // WCAG 2.1, 1.4.11: at least 3 to 1 for what is needed to see a control, all along its edge.
  for (int x = place.left() + 1; x < place.right(); ++x)
    for (const int y : {place.top(), place.bottom()})
      QVERIFY2(tests::contrast(picture.pixelColor(x, y), ground) >= 3,
               qPrintable(picture.pixelColor(x, y).name()));
}

QTEST_MAIN(OutlinedStyleTest)
#include "outlined_style_test.moc"
