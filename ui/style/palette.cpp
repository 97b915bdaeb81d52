#include "ui/style/palette.h"

#include "ui/style/theme.h"

namespace ui {
namespace {

/// The few colors a Fusion palette is made of.
struct Shades {
  QColor window;
  QColor base;
  QColor button;
  QColor text;
  QColor faintText;
  QColor disabledText;
  QColor accent;
  QColor onAccent;
};

Shades lightShades() {
  return {QColor("#f4f5f7"), QColor("#ffffff"), QColor("#eceff3"), QColor("#1b1f24"),
          QColor("#57606a"), QColor("#8b949e"), QColor("#0069a8"), QColor("#ffffff")};
}

Shades darkShades() {
  return {QColor("#262b32"), QColor("#1b1f24"), QColor("#343a43"), QColor("#f0f3f6"),
          QColor("#a9b2bd"), QColor("#79828d"), QColor("#56b4e9"), QColor("#0c1116")};
}

}  // namespace

QPalette paletteOf(const Theme& theme) {
  const Shades shades = theme.dark ? darkShades() : lightShades();
  QPalette palette(shades.button, shades.window);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                          QPalette::ToolTipText, QPalette::BrightText}) {
    palette.setColor(role, shades.text);
    palette.setColor(QPalette::Disabled, role, shades.disabledText);
  }
  palette.setColor(QPalette::Base, shades.base);
  palette.setColor(QPalette::AlternateBase, shades.window);
  palette.setColor(QPalette::ToolTipBase, shades.base);
  palette.setColor(QPalette::PlaceholderText, shades.faintText);
  palette.setColor(QPalette::Link, shades.accent);
  palette.setColor(QPalette::Highlight, shades.accent);
  palette.setColor(QPalette::HighlightedText, shades.onAccent);
  palette.setColor(QPalette::Disabled, QPalette::Base, shades.window);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, shades.disabledText);
  return palette;
}

}  // namespace ui
