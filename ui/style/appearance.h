#pragma once

#include <QFont>
#include <QObject>

namespace ui {

class DesktopScheme;

/// Which colors the user wants.
enum class ThemeChoice { kDesktop, kLight, kDark };

/// How large the user wants words to be, as far as the window then still fits the screen.
enum class TextSize { kNormal, kLarge, kVeryLarge };

/// Gives the whole application its looks: Fusion style, our own palette in light or dark,
/// and type large enough for a projector. Changes show at once everywhere.
class Appearance : public QObject {
  Q_OBJECT

 public:
  /// @pre there is a QApplication
  explicit Appearance(QObject* parent = nullptr);
  /// Leaves the type as large as it was before.
  ~Appearance() override;

  ThemeChoice choice() const { return m_choice; }
  void setChoice(ThemeChoice choice);

  TextSize textSize() const { return m_textSize; }
  void setTextSize(TextSize size);

  /// Type that can be read from the back row while a picture of this height is projected, and
  /// larger still if the user wants it large.
  /// @param height  of the screen [logical px]
  QFont presentedFont(int height) const;

 private:
  void applyColors();
  void applyType();
  double usualPoints() const;
  double share() const;

  DesktopScheme* m_desktop;
  ThemeChoice m_choice = ThemeChoice::kDesktop;
  TextSize m_textSize = TextSize::kNormal;
  QFont m_original;
};

}  // namespace ui
