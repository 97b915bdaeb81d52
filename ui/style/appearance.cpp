#include "ui/style/appearance.h"

#include <algorithm>
#include <array>

#include <QApplication>
#include <QScreen>

#include "ui/style/desktop_scheme.h"
#include "ui/style/outlined_style.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr double kSmallestType = 12;           // pt: readable from the back row
constexpr std::array kShares{1.0, 1.25, 1.5};  // in the order of TextSize
// Of the screen's height that type takes which can be read from the back row.
constexpr double kPresentedShare = 1.0 / 36;

/// Type that can be read from the back row on a screen so high [px].
double pointsOn(int height) {
  return height * kPresentedShare * 72 / QApplication::primaryScreen()->logicalDotsPerInchY();
}

}  // namespace

Appearance::Appearance(QObject* parent)
    : QObject(parent), m_desktop(new DesktopScheme(this)), m_original(QApplication::font()) {
  QApplication::setStyle(new OutlinedStyle);
  connect(m_desktop, &DesktopScheme::darkChanged, this, &Appearance::applyColors);
  applyColors();
  applyType();
}

Appearance::~Appearance() {
  if (QApplication::font() != m_original) QApplication::setFont(m_original);
}

void Appearance::setChoice(ThemeChoice choice) {
  m_choice = choice;
  applyColors();
}

void Appearance::setTextSize(TextSize size) {
  m_textSize = size;
  applyType();
}

QFont Appearance::presentedFont(int height) const {
  QFont font = m_original;
  font.setPointSizeF(std::max(usualPoints(), pointsOn(height)) * share());
  return font;
}

double Appearance::usualPoints() const {
  return std::max(kSmallestType, m_original.pointSizeF());
}

double Appearance::share() const {
  return kShares[static_cast<std::size_t>(m_textSize)];
}

void Appearance::applyColors() {
  const bool dark =
      m_choice == ThemeChoice::kDark || (m_choice == ThemeChoice::kDesktop && m_desktop->isDark());
  QApplication::setPalette(paletteOf(dark ? Theme::darkTheme() : Theme::light()));
}

/// A window full of forms has no room for more than what is seen from the back row.
void Appearance::applyType() {
  const double most = pointsOn(QApplication::primaryScreen()->size().height());
  QFont font = m_original;
  font.setPointSizeF(std::max(usualPoints(), std::min(usualPoints() * share(), most)));
  if (font != QApplication::font()) QApplication::setFont(font);
}

}  // namespace ui
