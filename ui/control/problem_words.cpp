#include "ui/control/problem_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

#include "core/scene/scene_limits.h"
#include "ui/control/quantity_text.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ProblemWords)
};

/// A place in a scene, taken apart: "weights[3].rope.length".
struct Place {
  explicit Place(const std::string& place) {
    static const QRegularExpression kPattern(R"(^(\w+)\[(\d+)\]\.?(.*)$)");
    const QString text = QString::fromStdString(place);
    const QRegularExpressionMatch match = kPattern.match(text);
    key = match.hasMatch() ? match.captured(3) : text;
    if (match.hasMatch()) number = match.captured(2).toInt() + 1;
  }

  QString key;
  int number = 0;  // of the weight or run, from 1; 0: neither
};

QString keyWords(const QString& key) {
  static const QHash<QString, const char*> kWords{
      {"gravity", QT_TRANSLATE_NOOP("ui::ProblemWords", "Gravity")},
      {"airDensity", QT_TRANSLATE_NOOP("ui::ProblemWords", "The air density")},
      {"room.width", QT_TRANSLATE_NOOP("ui::ProblemWords", "The room's width")},
      {"room.height", QT_TRANSLATE_NOOP("ui::ProblemWords", "The room's height")},
      {"room.restitution", QT_TRANSLATE_NOOP("ui::ProblemWords", "The room's restitution")},
      {"room.friction", QT_TRANSLATE_NOOP("ui::ProblemWords", "The friction")},
      {"restitution", QT_TRANSLATE_NOOP("ui::ProblemWords", "The weights' restitution")},
      {"cutTime", QT_TRANSLATE_NOOP("ui::ProblemWords", "The time of the cut")},
      {"mass", QT_TRANSLATE_NOOP("ui::ProblemWords", "The mass")},
      {"radius", QT_TRANSLATE_NOOP("ui::ProblemWords", "The radius")},
      {"dragCoefficient", QT_TRANSLATE_NOOP("ui::ProblemWords", "The drag coefficient")},
      {"rope.length", QT_TRANSLATE_NOOP("ui::ProblemWords", "The rope's length")},
      {"rope.angle", QT_TRANSLATE_NOOP("ui::ProblemWords", "The start angle")},
      {"rope.angularVelocity", QT_TRANSLATE_NOOP("ui::ProblemWords", "The angular velocity")},
      {"velocity[0]", QT_TRANSLATE_NOOP("ui::ProblemWords", "The velocity x")},
      {"velocity[1]", QT_TRANSLATE_NOOP("ui::ProblemWords", "The velocity y")},
      {"step", QT_TRANSLATE_NOOP("ui::ProblemWords", "The step")},
      {"tolerance", QT_TRANSLATE_NOOP("ui::ProblemWords", "The tolerance")},
  };
  const char* words = kWords.value(key);
  return words ? Words::tr(words) : key;
}

QString outsideWords(const Place& place) {
  if (place.key == "rope.pivot") {
    return Words::tr("The rope of weight %1 is tied outside the room.").arg(place.number);
  }
  return Words::tr("Weight %1 does not start inside the room.").arg(place.number);
}

QString rangeWords(const Place& place, const core::Problem& problem) {
  const QString range = rangeText(problem.allowed);
  if (place.number == 0) return Words::tr("%1 must be %2.").arg(keyWords(place.key), range);
  return Words::tr("%1 (number %2) must be %3.")
      .arg(keyWords(place.key))
      .arg(place.number)
      .arg(range);
}

QString tooManyWords(const Place& place, const core::Problem& problem) {
  const QString most = quantityText(problem.allowed.highest);
  return place.key == "solvers" ? Words::tr("There are more than %1 runs.").arg(most)
                                : Words::tr("There are more than %1 weights.").arg(most);
}

}  // namespace

QString problemWords(const core::Problem& problem) {
  const Place place(problem.place);
  switch (problem.kind) {
    case core::Problem::Kind::kOutOfRange:
      return rangeWords(place, problem);
    case core::Problem::Kind::kOutsideRoom:
      return outsideWords(place);
    case core::Problem::Kind::kOverlap:
      return Words::tr("Weights %1 and %2 overlap at the start.")
          .arg(qMin(place.number, problem.other + 1))
          .arg(qMax(place.number, problem.other + 1));
    case core::Problem::Kind::kTooMany:
      return tooManyWords(place, problem);
  }
  return {};
}

QString problemWords(const std::vector<core::Problem>& problems) {
  const QString first = problemWords(problems.front());
  const int more = static_cast<int>(problems.size()) - 1;
  return more == 0
             ? first
             : first + QChar(QChar::Space) + Words::tr("(and %n more problem(s))", nullptr, more);
}

}  // namespace ui
