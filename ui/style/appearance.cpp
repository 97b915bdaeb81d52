#include "ui/style/appearance.h"

#include <QApplication>
#include <QFont>
#include <QStyleFactory>

#include "ui/style/desktop_scheme.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr double kSmallestType = 12;  // pt: readable from the back row

}  // namespace

Appearance::Appearance(QObject* parent) : QObject(parent), m_desktop(new DesktopScheme(this)) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QFont font = QApplication::font();
  if (font.pointSizeF() < kSmallestType) font.setPointSizeF(kSmallestType);
  QApplication::setFont(font);
  connect(m_desktop, &DesktopScheme::darkChanged, this, &Appearance::apply);
  apply();
}

void Appearance::setChoice(ThemeChoice choice) {
  m_choice = choice;
  apply();
}

void Appearance::apply() {
  const bool dark =
      m_choice == ThemeChoice::kDark || (m_choice == ThemeChoice::kDesktop && m_desktop->isDark());
  QApplication::setPalette(paletteOf(dark ? Theme::darkTheme() : Theme::light()));
}

}  // namespace ui
