#pragma once

#include <QObject>

namespace ui {

class DesktopScheme;

/// Which colors the user wants.
enum class ThemeChoice { kDesktop, kLight, kDark };

/// Gives the whole application its looks: Fusion style, our own palette in light or dark,
/// and type large enough for a projector.
class Appearance : public QObject {
  Q_OBJECT

 public:
  /// @pre there is a QApplication
  explicit Appearance(QObject* parent = nullptr);

  ThemeChoice choice() const { return m_choice; }
  void setChoice(ThemeChoice choice);

 private:
  void apply();

  DesktopScheme* m_desktop;
  ThemeChoice m_choice = ThemeChoice::kDesktop;
};

}  // namespace ui
