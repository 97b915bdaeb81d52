#pragma once

#include <optional>

#include <QAbstractSpinBox>

#include "core/scene/scene_limits.h"

namespace ui {

/// How a quantity is shown and how the arrows change it.
struct QuantityStyle {
  core::Range range;           ///< as shown: degrees for angles
  double arrowStep = 0.1;      ///< added or taken away by an arrow, > 0
  bool arrowsDouble = false;   ///< arrows double and halve instead, and 1/240 is shown so
  bool arrowsTenfold = false;  ///< arrows multiply and divide by ten instead
  bool wholeNumbers = false;   ///< 3.5 is refused
};

/// A spin box that lets anything be typed and judges it only when it is done with: nothing
/// is clamped or corrected on the way. Works in shown units.
///
/// Return hands the keyboard back to the window, whose keys a teacher wants next; the space
/// bar is the window's at all times, since no number has one; undo is while nothing is typed.
class QuantitySpinBox : public QAbstractSpinBox {
  Q_OBJECT

 public:
  explicit QuantitySpinBox(const QuantityStyle& style, QWidget* parent = nullptr);

  const QuantityStyle& style() const { return m_style; }
  QString unit() const;

  void showValue(double value);
  /// Shows that there is not one value: "several", or what setEmptyWords() said.
  void showNone();
  void setEmptyWords(const QString& words);

  /// What is typed now; nothing if it is no number or not in the range.
  std::optional<double> typedValue() const;
  /// False once the user has typed something new.
  bool isUntouched() const { return text() == m_shownText; }
  /// True while committed() tells of an arrow, not of something typed.
  bool isStepping() const { return m_stepping; }

  void setMarked(bool marked);

  void stepBy(int steps) override;
  QSize sizeHint() const override;

 signals:
  /// The user is done with the text: typed and left, or clicked an arrow.
  void committed();
  /// The user wants the last value back.
  void cancelled();
  void typed();

 protected:
  StepEnabled stepEnabled() const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  double stepped(double value, int steps) const;
  void setShownText(const QString& text);

  QuantityStyle m_style;
  QString m_shownText;
  bool m_marked = false;
  bool m_stepping = false;
};

}  // namespace ui
