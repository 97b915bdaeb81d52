#pragma once

#include <optional>

#include <QString>
#include <QWidget>

#include "ui/panels/quantity_spin_box.h"

class QLabel;

namespace ui {

/// A field for one quantity with its unit. Angles are degrees on screen and radians for the
/// rest of the program; everything else is in the range's own unit.
///
/// A bad value stays as it was typed, is marked with the allowed range below it, and goes
/// nowhere. Escape brings back the last good one.
class QuantityField : public QWidget {
  Q_OBJECT

 public:
  explicit QuantityField(const QuantityStyle& style, QWidget* parent = nullptr);
  ~QuantityField() override;

  /// Tells screen readers what it is called, and everybody who points at it what it means.
  void setName(const QString& name, const QString& meaning);

  /// Shows a value, unless it is the one already shown with something bad typed over it.
  /// @param value  in SI units, radians for angles
  void setValue(double value);
  /// Shows that there is not one value, such as several; typing one sets them all.
  void setNoValue();
  /// Drops what was typed and not applied.
  void discard();

  /// Marks the value, which cannot stand, with the reason in words.
  void mark(const QString& reason);
  void clearMark();
  bool isMarked() const { return !m_reason.isEmpty(); }
  QString reason() const { return m_reason; }

  QuantitySpinBox* spinBox() const { return m_spinBox; }

 signals:
  /// The user set another value, and it lies in the range. SI units, radians for angles.
  void edited(double value);
  /// The user wants the last value back.
  void cancelled();

 private:
  void takeTyped();
  void showCurrent();

  double m_shownPerValue;  // degrees per radian, or 1
  std::optional<double> m_value;
  bool m_holdsBadText = false;
  QString m_reason;
  QString m_meaning;
  QuantitySpinBox* m_spinBox;
  QLabel* m_reasonLabel;
};

}  // namespace ui
