#include "ui/control/quantity_text.h"

#include <cmath>
#include <limits>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace ui {
namespace {

constexpr int kShownDigits = 12;

std::optional<double> parsedNumber(QString text) {
  text = text.trimmed().replace(',', '.');
  bool isNumber = false;
  const double value = QLocale::c().toDouble(text, &isNumber);
  if (!isNumber || !std::isfinite(value)) return std::nullopt;
  return value;
}

double inShownDigits(double value) {
  return QString::number(value, 'g', kShownDigits).toDouble();
}

/// A space that does not break before the unit, but none before the degree sign.
QString withUnit(const QString& number, std::string_view unit) {
  const QString words = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
  if (words.isEmpty()) return number;
  return words == "°" ? number + words : number + QChar(QChar::Nbsp) + words;
}

}  // namespace

std::optional<double> parsedQuantity(const QString& text, const QString& unit) {
  QString number = text.trimmed();
  if (!unit.isEmpty() && number.endsWith(unit)) number.chop(unit.size());
  number.replace(QChar(0x2212), '-');

  const QStringList parts = number.split('/');
  if (parts.size() > 2) return std::nullopt;
  const std::optional<double> whole = parsedNumber(parts.first());
  if (parts.size() == 1 || !whole) return whole;
  const std::optional<double> divisor = parsedNumber(parts.last());
  if (!divisor || !std::isfinite(*whole / *divisor)) return std::nullopt;
  return *whole / *divisor;
}

QString quantityText(double value) {
  QString text = QString::fromStdString(core::numberText(inShownDigits(value)));
  return text.replace('.', QLocale().decimalPoint());
}

QString fractionText(double value) {
  const double parts = std::round(1 / value);
  const bool isPart = parts >= 2 && parts < 1e7 && std::abs(value * parts - 1) < 1e-12;
  return isPart ? "1/" + quantityText(parts) : quantityText(value);
}

QString rangeText(const core::Range& range) {
  if (range.highest == std::numeric_limits<double>::max()) {
    return QCoreApplication::translate("ui::Range", "%1 or more")
        .arg(withUnit(quantityText(range.lowest), range.unit));
  }
  return QCoreApplication::translate("ui::Range", "from %1 to %2")
      .arg(quantityText(range.lowest), withUnit(quantityText(range.highest), range.unit));
}

}  // namespace ui
