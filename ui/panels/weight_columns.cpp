#include "ui/panels/weight_columns.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <QColor>
#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include "core/scene/angle.h"
#include "ui/control/quantity_text.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::WeightColumns)
};

constexpr core::Range kPlaceRange{0, core::kRoomSizeRange.highest, "m"};
constexpr double kUsualRope = 1;  // m: length where there is room

/// Whose cells they are.
enum class Holder { kAll, kHanging, kFree };

using Place = double* (*)(core::Weight&);

/// One column; those without a place hold words.
struct Column {
  const char* name;
  const char* key;  // as in scene files; several may share one
  Holder holder;
  core::Range range;
  Place place;
};

const Column& columnAt(WeightColumn column) {
  static constexpr std::array<Column, kWeightColumnCount> kColumns{{
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Mass"), "mass", Holder::kAll, core::kMassRange,
       [](core::Weight& weight) { return &weight.mass; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Radius"), "radius", Holder::kAll, core::kRadiusRange,
       [](core::Weight& weight) { return &weight.radius; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Drag coefficient"), "dragCoefficient", Holder::kAll,
       core::kDragCoefficientRange, [](core::Weight& weight) { return &weight.dragCoefficient; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Color"), "color", Holder::kAll, {0, 0, ""}, nullptr},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Hangs on"), "", Holder::kAll, {0, 0, ""}, nullptr},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Pivot x"), "rope.pivot", Holder::kHanging,
       kPlaceRange, [](core::Weight& weight) { return &weight.rope->pivot.x(); }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Pivot y"), "rope.pivot", Holder::kHanging,
       kPlaceRange, [](core::Weight& weight) { return &weight.rope->pivot.y(); }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Length"), "rope.length", Holder::kHanging,
       core::kRopeLengthRange, [](core::Weight& weight) { return &weight.rope->length; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Start angle"), "rope.angle", Holder::kHanging,
       core::kRopeAngleRange, [](core::Weight& weight) { return &weight.rope->angle; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Angular velocity"), "rope.angularVelocity",
       Holder::kHanging, core::kAngularVelocityRange,
       [](core::Weight& weight) { return &weight.rope->angularVelocity; }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "x"), "position", Holder::kFree, kPlaceRange,
       [](core::Weight& weight) { return &weight.position.x(); }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "y"), "position", Holder::kFree, kPlaceRange,
       [](core::Weight& weight) { return &weight.position.y(); }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Velocity x"), "velocity[0]", Holder::kFree,
       core::kVelocityRange, [](core::Weight& weight) { return &weight.velocity.x(); }},
      {QT_TRANSLATE_NOOP("ui::WeightColumns", "Velocity y"), "velocity[1]", Holder::kFree,
       core::kVelocityRange, [](core::Weight& weight) { return &weight.velocity.y(); }},
  }};
  return kColumns[static_cast<std::size_t>(column)];
}

QString unitOf(const core::Range& range) {
  return QString::fromUtf8(range.unit.data(), static_cast<qsizetype>(range.unit.size()));
}

bool isAngle(const core::Range& range) {
  return range.unit.starts_with("°");
}

/// What the column shows of the weight: degrees for angles.
double shownNumber(core::Weight weight, const Column& column) {
  const double value = *column.place(weight);
  return isAngle(column.range) ? core::degrees(value) : value;
}

QString gotInstead(const QString& demand, const QString& text) {
  return Words::tr("must be %1, got “%2”").arg(demand, text.trimmed());
}

QString setNumber(core::Weight& weight, const Column& column, const QString& text) {
  const std::optional<double> value = parsedQuantity(text, unitOf(column.range));
  if (!value || !column.range.contains(*value)) return gotInstead(rangeText(column.range), text);
  *column.place(weight) = isAngle(column.range) ? core::radians(*value) : *value;
  return {};
}

QString colorText(const core::Weight& weight) {
  if (!weight.color) return Words::tr("automatic");
  return QColor(weight.color->red, weight.color->green, weight.color->blue).name();
}

QString setColor(core::Weight& weight, const QString& text) {
  const QString wanted = text.trimmed();
  if (wanted.isEmpty() || wanted.compare(Words::tr("automatic"), Qt::CaseInsensitive) == 0) {
    weight.color.reset();
    return {};
  }
  static const QRegularExpression kPattern(QStringLiteral("\\A#[0-9A-Fa-f]{6}\\z"));
  if (!kPattern.match(wanted).hasMatch())
    return gotInstead(Words::tr("like #e69f00, or automatic"), text);
  const QColor color(wanted);
  weight.color =
      core::Color{static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
                  static_cast<std::uint8_t>(color.blue())};
  return {};
}

QString ropeText(const core::Weight& weight) {
  if (!weight.rope) return holdings().first();
  return holdings().at(weight.rope->rigid ? 2 : 1);
}

void takeDown(core::Weight& weight) {
  const Eigen::Vector2d position = core::startPosition(weight);
  const Eigen::Vector2d velocity = core::startVelocity(weight);
  weight.position = position;
  weight.velocity = velocity;
  weight.rope.reset();
}

/// Tied right above where it is, as high as a usual rope reaches in the room.
void hangUp(core::Weight& weight, const core::Room& room) {
  core::Rope rope;
  const double above = std::min(kUsualRope, room.height - weight.position.y());
  rope.length = std::max(above, core::kRopeLengthRange.lowest);
  rope.pivot = weight.position + Eigen::Vector2d(0, rope.length);
  rope.angularVelocity = weight.velocity.x() / rope.length;
  weight.rope = rope;
  weight.position = core::Weight().position;
  weight.velocity = core::Weight().velocity;
}

QString setHolding(core::Weight& weight, const core::Room& room, const QString& text) {
  const QStringList words = holdings();
  const auto holding = std::ranges::find_if(words, [&](const QString& word) {
    return word.compare(text.trimmed(), Qt::CaseInsensitive) == 0;
  });
  if (holding == words.end())
    return gotInstead(Words::tr("%1, %2 or %3").arg(words[1], words[2], words[0]), text);
  const auto chosen = std::distance(words.begin(), holding);
  if (chosen == 0 && weight.rope) takeDown(weight);
  if (chosen != 0 && !weight.rope) hangUp(weight, room);
  if (chosen != 0) weight.rope->rigid = chosen == 2;
  return {};
}

}  // namespace

QStringList holdings() {
  return {Words::tr("nothing"), Words::tr("rope"), Words::tr("rod")};
}

QString columnMeaning(WeightColumn column) {
  switch (column) {
    case WeightColumn::kMass:
      return Words::tr(
          "Mass m, in kg. It does not matter for a swing without air; with air a heavier "
          "weight is slowed down less.");
    case WeightColumn::kRadius:
      return Words::tr("Radius r, in m. Air meets the area A = π r².");
    case WeightColumn::kDragCoefficient:
      return Words::tr(
          "Drag coefficient c_d, without unit: how well the shape is held up by air. "
          "0.47 for a sphere.");
    case WeightColumn::kColor:
      return Words::tr("Color of the weight, such as #e69f00, or automatic");
    case WeightColumn::kHangsOn:
      return Words::tr("What holds the weight at the start: a rope, a rod, or nothing");
    case WeightColumn::kPivotX:
    case WeightColumn::kPivotY:
      return Words::tr("Where the rope is tied: x from the left wall, y from the floor, in m");
    case WeightColumn::kLength:
      return Words::tr(
          "Length of the rope L, in m: from its pivot to the center of the weight. A "
          "small swing takes T = 2π √(L/g).");
    case WeightColumn::kAngle:
      return Words::tr(
          "Angle θ of the rope at the start, in degrees from straight down, positive to "
          "the right.");
    case WeightColumn::kAngularVelocity:
      return Words::tr("Angular velocity ω at the start, in °/s, positive counterclockwise");
    case WeightColumn::kX:
    case WeightColumn::kY:
      return Words::tr(
          "Center of the weight at the start: x from the left wall, y from the floor, "
          "in m");
    default:
      return Words::tr("Velocity v at the start: x to the right, y up, in m/s");
  }
}

QString columnName(WeightColumn column) {
  return Words::tr(columnAt(column).name);
}

QString columnHeading(WeightColumn column) {
  const QString unit = unitOf(columnAt(column).range);
  return unit.isEmpty() ? columnName(column)
                        : QStringLiteral("%1 [%2]").arg(columnName(column), unit);
}

std::optional<WeightColumn> columnOfKey(const QString& key) {
  if (key.isEmpty()) return std::nullopt;
  for (int i = 0; i < kWeightColumnCount; ++i)
    if (key == QLatin1String(columnAt(WeightColumn(i)).key)) return WeightColumn(i);
  return std::nullopt;
}

bool hasCell(const core::Weight& weight, WeightColumn column) {
  const Holder holder = columnAt(column).holder;
  return holder == Holder::kAll || (holder == Holder::kHanging) == weight.rope.has_value();
}

QString cellText(const core::Weight& weight, WeightColumn column) {
  if (!hasCell(weight, column)) return {};
  if (column == WeightColumn::kColor) return colorText(weight);
  if (column == WeightColumn::kHangsOn) return ropeText(weight);
  return quantityText(shownNumber(weight, columnAt(column)));
}

QString exactCellText(const core::Weight& weight, WeightColumn column) {
  const Column& described = columnAt(column);
  if (!described.place || !hasCell(weight, column)) return cellText(weight, column);
  const QString text = QString::fromStdString(core::numberText(shownNumber(weight, described)));
  return QString(text).replace('.', QLocale().decimalPoint());
}

QString setCell(core::Weight& weight, const core::Room& room, WeightColumn column,
                const QString& text) {
  if (column == WeightColumn::kColor) return setColor(weight, text);
  if (column == WeightColumn::kHangsOn) return setHolding(weight, room, text);
  return setNumber(weight, columnAt(column), text);
}

}  // namespace ui
