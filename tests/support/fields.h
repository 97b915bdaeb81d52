#pragma once

#include <QString>
#include <QTest>
#include <QWidget>

#include "ui/panels/quantity_field.h"

namespace tests {

/// The field in a window or form that a screen reader would announce by that name.
inline ui::QuantityField* fieldNamed(const QWidget& parent, const QString& name) {
  for (ui::QuantityField* field : parent.findChildren<ui::QuantityField*>()) {
    if (field->spinBox()->accessibleName() == name) return field;
  }
  qFatal("no field named %s", qPrintable(name));
}

/// Types a value in place of what is there, and Enter.
inline void enter(ui::QuantityField* field, const QString& text) {
  field->spinBox()->setFocus();
  field->spinBox()->selectAll();
  QTest::keyClicks(field->spinBox(), text);
  QTest::keyClick(field->spinBox(), Qt::Key_Return);
}

}  // namespace tests
