#include "ui/panels/quantity_spin_box.h"

#include <cmath>

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QScopedValueRollback>

#include "ui/control/quantity_text.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kWidthInDigits = 11;

}  // namespace

QuantitySpinBox::QuantitySpinBox(const QuantityStyle& style, QWidget* parent)
    : QAbstractSpinBox(parent), m_style(style) {
  setFocusPolicy(Qt::StrongFocus);
  setKeyboardTracking(false);
  ignoreWheelWithoutFocus(this);
  lineEdit()->setAlignment(Qt::AlignRight);
  setEmptyWords(tr("several"));
  connect(lineEdit(), &QLineEdit::textEdited, this, &QuantitySpinBox::typed);
  connect(this, &QAbstractSpinBox::editingFinished, this, &QuantitySpinBox::committed);
}

QString QuantitySpinBox::unit() const {
  const std::string_view unit = m_style.range.unit;
  return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

void QuantitySpinBox::setShownText(const QString& text) {
  m_shownText = text;
  if (text != this->text()) lineEdit()->setText(text);
}

void QuantitySpinBox::showValue(double value) {
  const QString number = m_style.arrowsDouble ? fractionText(value) : quantityText(value);
  const QString space = unit().isEmpty() || unit() == "°" ? QString() : QStringLiteral(" ");
  setShownText(number + space + unit());
}

void QuantitySpinBox::showNone() {
  setShownText({});
}

void QuantitySpinBox::setEmptyWords(const QString& words) {
  lineEdit()->setPlaceholderText(words);
}

std::optional<double> QuantitySpinBox::typedValue() const {
  const std::optional<double> value = parsedQuantity(text(), unit());
  if (!value || !m_style.range.contains(*value)) return std::nullopt;
  if (m_style.wholeNumbers && *value != std::floor(*value)) return std::nullopt;
  return value;
}

void QuantitySpinBox::setMarked(bool marked) {
  m_marked = marked;
  update();
}

double QuantitySpinBox::stepped(double value, int steps) const {
  if (m_style.arrowsDouble) return std::ldexp(value, steps);
  if (m_style.arrowsTenfold) return value * std::pow(10.0, steps);
  // On whole multiples of the arrow's step, so that 9.81 goes to 9.9 and back to 9.8.
  const double multiples = value / m_style.arrowStep;
  const double nearest = std::round(multiples);
  const bool isMultiple = std::abs(multiples - nearest) < 1e-6;
  const double start = isMultiple  ? nearest
                       : steps > 0 ? std::floor(multiples)
                                   : std::ceil(multiples);
  return (start + steps) * m_style.arrowStep;
}

void QuantitySpinBox::stepBy(int steps) {
  const std::optional<double> value = typedValue();
  if (!value) return;
  const double next = stepped(*value, steps);
  if (!m_style.range.contains(next)) return;
  const QString before = m_shownText;
  showValue(next);
  m_shownText = before;
  const QScopedValueRollback stepping(m_stepping, true);
  emit committed();
}

QAbstractSpinBox::StepEnabled QuantitySpinBox::stepEnabled() const {
  const std::optional<double> value = typedValue();
  StepEnabled enabled = StepNone;
  if (!value) return enabled;
  if (m_style.range.contains(stepped(*value, 1))) enabled |= StepUpEnabled;
  if (m_style.range.contains(stepped(*value, -1))) enabled |= StepDownEnabled;
  return enabled;
}

bool QuantitySpinBox::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QAbstractSpinBox::event(event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool isSpace = key->key() == Qt::Key_Space;
  if (isSpace) emit committed();
  const bool isUndo = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
  if (!isSpace && !(isUndo && isUntouched())) return QAbstractSpinBox::event(event);
  event->ignore();
  return true;
}

void QuantitySpinBox::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->key() == Qt::Key_Escape) emit cancelled();
  if (isReturn) emit committed();
  if (isReturn || event->key() == Qt::Key_Escape) {
    clearFocus();
    return;
  }
  QAbstractSpinBox::keyPressEvent(event);
}

void QuantitySpinBox::paintEvent(QPaintEvent* event) {
  QAbstractSpinBox::paintEvent(event);
  if (!m_marked) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Theme::of(palette()).drift, 2));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
}

QSize QuantitySpinBox::sizeHint() const {
  const QSize base = QAbstractSpinBox::sizeHint();
  return {fontMetrics().horizontalAdvance('0') * kWidthInDigits + base.height(), base.height()};
}

}  // namespace ui
