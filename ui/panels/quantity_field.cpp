#include "ui/panels/quantity_field.h"

#include <numbers>

#include <QVBoxLayout>

#include "ui/control/quantity_text.h"
#include "ui/panels/warning_label.h"

namespace ui {

QuantityField::QuantityField(const QuantityStyle& style, QWidget* parent)
    : QWidget(parent),
      m_shownPerValue(style.range.unit == "°" ? 180 / std::numbers::pi : 1),
      m_spinBox(new QuantitySpinBox(style)),
      m_reasonLabel(new WarningLabel) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_spinBox);
  layout->addWidget(m_reasonLabel);
  setFocusProxy(m_spinBox);
  connect(m_spinBox, &QuantitySpinBox::committed, this, &QuantityField::takeTyped);
  connect(m_spinBox, &QuantitySpinBox::cancelled, this, [this] {
    discard();
    emit cancelled();
  });
}

QuantityField::~QuantityField() {
  // A spin box that has the focus commits once more when its window goes.
  m_spinBox->disconnect(this);
}

void QuantityField::setName(const QString& name, const QString& meaning) {
  m_meaning = meaning;
  m_spinBox->setAccessibleName(name);
  m_spinBox->setAccessibleDescription(meaning);
  m_spinBox->setToolTip(meaning);
}

void QuantityField::setValue(double value) {
  if (m_holdsBadText && m_value == value) return;
  m_value = value;
  discard();
}

void QuantityField::setNoValue() {
  if (m_holdsBadText && !m_value) return;
  m_value.reset();
  discard();
}

void QuantityField::discard() {
  m_holdsBadText = false;
  clearMark();
  showCurrent();
}

void QuantityField::showCurrent() {
  if (m_value) {
    m_spinBox->showValue(*m_value * m_shownPerValue);
  } else {
    m_spinBox->showNone();
  }
}

void QuantityField::takeTyped() {
  if (m_spinBox->isUntouched()) {
    if (m_holdsBadText) discard();
    return;
  }
  const std::optional<double> shown = m_spinBox->typedValue();
  m_holdsBadText = !shown;
  if (!shown) {
    mark(tr("Must be %1").arg(rangeText(m_spinBox->style().range)));
    return;
  }
  m_value = *shown / m_shownPerValue;
  clearMark();
  showCurrent();
  emit edited(*m_value);
}

void QuantityField::mark(const QString& reason) {
  m_reason = reason;
  m_spinBox->setMarked(true);
  m_spinBox->setAccessibleDescription(reason);
  m_reasonLabel->setText(reason);
  m_reasonLabel->show();
}

void QuantityField::clearMark() {
  m_reason.clear();
  m_spinBox->setMarked(false);
  m_spinBox->setAccessibleDescription(m_meaning);
  m_reasonLabel->hide();
}

}  // namespace ui
