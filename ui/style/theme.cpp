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
  theme.kinetic = QColor("#d55e00");
  theme.potential = QColor("#0072b2");
  theme.lostToAir = QColor("#007a5a");
  theme.lostToImpacts = QColor("#a3478a");
  theme.lostToRopes = QColor("#8a6d00");
  theme.lostToFriction = QColor("#767d86");
  theme.total = QColor("#1b1f24");
  theme.drift = QColor("#c0002f");
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
  theme.kinetic = QColor("#ff9d4d");
  theme.potential = QColor("#56b4e9");
  theme.lostToAir = QColor("#2fd1a2");
  theme.lostToImpacts = QColor("#e29ccb");
  theme.lostToRopes = QColor("#f0e442");
  theme.lostToFriction = QColor("#9aa3ad");
  theme.total = QColor("#f0f3f6");
  theme.drift = QColor("#ff6b81");
  return theme;
}

Theme Theme::of(const QPalette& palette) {
  const bool dark =
      palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  return dark ? darkTheme() : light();
}

}  // namespace ui
