#include "ui/files/problem_line.h"

#include <limits>

#include <QCoreApplication>

#include "core/scene/scene_limits.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ProblemLine)
};

QString number(double value) {
  return QString::fromStdString(core::numberText(value));
}

QString withUnit(double value, std::string_view unit) {
  const QString words = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
  return words.isEmpty() ? number(value) : number(value) + ' ' + words;
}

QString pairText(const Eigen::Vector2d& pair) {
  return '[' + number(pair.x()) + ", " + number(pair.y()) + ']';
}

QString outOfRange(double value, const core::Range& allowed) {
  const QString lowest = withUnit(allowed.lowest, allowed.unit);
  if (allowed.highest == std::numeric_limits<double>::max())
    return Words::tr("must be at least %1, got %2").arg(lowest, number(value));
  return Words::tr("must be from %1 to %2, got %3")
      .arg(number(allowed.lowest), withUnit(allowed.highest, allowed.unit), number(value));
}

QString outsideRoom(double radius, const Eigen::Vector2d& at) {
  if (radius == 0) return Words::tr("must be inside the room, got %1").arg(pairText(at));
  return Words::tr("must put the whole weight, of radius %1 m, inside the room, got %2")
      .arg(number(radius), pairText(at));
}

QString faultOf(const core::Problem& problem) {
  switch (problem.kind) {
    case core::Problem::Kind::kOutOfRange:
      return outOfRange(problem.value, problem.allowed);
    case core::Problem::Kind::kOutsideRoom:
      return outsideRoom(problem.value, problem.at);
    case core::Problem::Kind::kOverlap:
      return Words::tr("must not overlap %1 at the start")
          .arg(QStringLiteral("weights[%1]").arg(problem.other));
    case core::Problem::Kind::kTooMany:
      return Words::tr("must be at most %1, got %2")
          .arg(number(problem.allowed.highest), number(problem.value));
  }
  return {};
}

}  // namespace

QString problemLine(const core::Problem& problem) {
  return QString::fromStdString(problem.place) + QStringLiteral(": ") + faultOf(problem);
}

}  // namespace ui
