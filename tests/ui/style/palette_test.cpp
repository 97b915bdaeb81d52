#include "ui/style/palette.h"

#include <QTest>

#include "tests/support/contrast.h"
#include "ui/style/theme.h"

using tests::contrast;

class PaletteTest : public QObject {
  Q_OBJECT

 private slots:
  void everyTextCanBeRead_data();
  void everyTextCanBeRead();
  void makesDrawingsFollow();
};

void PaletteTest::everyTextCanBeRead_data() {
  QTest::addColumn<bool>("dark");
  QTest::addColumn<QPalette::ColorRole>("text");
  QTest::addColumn<QPalette::ColorRole>("ground");
  for (const bool dark : {false, true}) {
    const auto row = [dark](const char* name) -> QTestData& {
      return QTest::addRow("%s %s", dark ? "dark" : "light", name);
    };
    row("window") << dark << QPalette::WindowText << QPalette::Window;
    row("field") << dark << QPalette::Text << QPalette::Base;
    row("button") << dark << QPalette::ButtonText << QPalette::Button;
    row("selection") << dark << QPalette::HighlightedText << QPalette::Highlight;
    row("hint") << dark << QPalette::PlaceholderText << QPalette::Base;
    row("tool tip") << dark << QPalette::ToolTipText << QPalette::ToolTipBase;
    row("link") << dark << QPalette::Link << QPalette::Base;
  }
}

void PaletteTest::everyTextCanBeRead() {
  QFETCH(bool, dark);
  QFETCH(QPalette::ColorRole, text);
  QFETCH(QPalette::ColorRole, ground);
  const QPalette palette = ui::paletteOf(dark ? ui::Theme::darkTheme() : ui::Theme::light());
  // Level AA of the guidelines.
  QVERIFY(contrast(palette.color(text), palette.color(ground)) >= 4.5);
}

void PaletteTest::makesDrawingsFollow() {
  QVERIFY(ui::Theme::of(ui::paletteOf(ui::Theme::darkTheme())).dark);
  QVERIFY(!ui::Theme::of(ui::paletteOf(ui::Theme::light())).dark);
}

QTEST_MAIN(PaletteTest)
#include "palette_test.moc"
