#include "ui/style/theme.h"

#include <QPalette>

namespace ui {

Theme Theme::light() {
  Theme theme;
  theme.dark = false;
  theme.background = QColor("#f4f5f7");
  theme.room = QColor("#ffffff");
  theme.wall = QColor("#3b4048");
  theme.grid = QColor("#dfe3e8");
  theme.text = QColor("#1b1f24");
  theme.faintText = QColor("#57606a");
  theme.rope = QColor("#6e5a44");
  theme.outline = QColor("#1b1f24");
  theme.runs = {QColor("#1b1f24"), QColor("#5522ee"), QColor("#cc0033"), QColor("#8a0a8a")};
  theme.kinetic = QColor("#d47519");
  theme.potential = QColor("#2282d6");
  theme.lostToAir = QColor("#0a5533");
  theme.lostToImpacts = QColor("#733286");
  theme.lostToRopes = QColor("#8a4906");
  theme.lostToFriction = QColor("#8e88ac");
  theme.total = QColor("#1b1f24");
  theme.drift = QColor("#de005f");
  return theme;
}

Theme Theme::darkTheme() {
  Theme theme;
  theme.dark = true;
  theme.background = QColor("#15181c");
  theme.room = QColor("#1e2227");
  theme.wall = QColor("#aeb6c0");
  theme.grid = QColor("#343a42");
  theme.text = QColor("#f0f3f6");
  theme.faintText = QColor("#a9b2bd");
  theme.rope = QColor("#c8ae8c");
  theme.outline = QColor("#f0f3f6");
  theme.runs = {QColor("#f0f3f6"), QColor("#a070ff"), QColor("#ff3366"), QColor("#7ef06a")};
  theme.kinetic = QColor("#e88919");
  theme.potential = QColor("#39acf8");
  theme.lostToAir = QColor("#5df5a8");
  theme.lostToImpacts = QColor("#e293c3");
  theme.lostToRopes = QColor("#f8dc0f");
  theme.lostToFriction = QColor("#896c72");
  theme.total = QColor("#f0f3f6");
  theme.drift = QColor("#fd5955");
  return theme;
}

Theme Theme::of(const QPalette& palette) {
  const bool dark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  return dark ? darkTheme() : light();
}

}  // namespace ui
