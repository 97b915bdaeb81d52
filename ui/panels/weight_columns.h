#pragma once

#include <optional>

#include <QString>
#include <QStringList>

#include "core/scene/scene.h"
#include "core/scene/scene_limits.h"

namespace ui {

/// What a table of weights tells of each, in the order of its columns.
enum class WeightColumn {
  kMass,
  kRadius,
  kDragCoefficient,
  kColor,
  kHangsOn,
  kPivotX,
  kPivotY,
  kLength,
  kAngle,
  kAngularVelocity,
  kX,
  kY,
  kVelocityX,
  kVelocityY,
};

inline constexpr int kWeightColumnCount = 14;

/// "Angular velocity".
QString columnName(WeightColumn column);
/// What stands in it, in a sentence or two, with symbol and unit; what a form's field for the same
/// quantity says.
QString columnMeaning(WeightColumn column);
/// The name and the unit in brackets: "Angular velocity [°/s]".
QString columnHeading(WeightColumn column);
/// What a weight can hang on, in words: nothing, a rope, a rod.
QStringList holdings();
/// The column of a key as in Problem::place: "rope.length"; nothing for others.
std::optional<WeightColumn> columnOfKey(const QString& key);

/// Whether the weight has such a thing: only one that hangs has a pivot, only one that does
/// not a position.
bool hasCell(const core::Weight& weight, WeightColumn column);

/// As it is shown; empty where the weight has no such thing.
QString cellText(const core::Weight& weight, WeightColumn column);
/// In as many digits as are needed to read it back.
QString exactCellText(const core::Weight& weight, WeightColumn column);

/// Takes what a person typed or a spreadsheet holds, with point or comma before decimals.
///
/// A weight that is hung up or taken down stays where it is.
/// @param room    where it is hung up
/// @return  empty, or why not: "must be from 0 to 10, got “x”"; the weight is unchanged then
/// @pre hasCell(weight, column)
QString setCell(core::Weight& weight, const core::Room& room, WeightColumn column,
                const QString& text);

}  // namespace ui
