#include "ui/control/event_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::EventWords)
};

EventGroup groupOf(core::EventKind kind) {
  switch (kind) {
    case core::EventKind::kCut:
      return EventGroup::kCuts;
    case core::EventKind::kTurningPoint:
      return EventGroup::kTurningPoints;
    case core::EventKind::kSlack:
    case core::EventKind::kTaut:
      return EventGroup::kRopes;
    case core::EventKind::kRest:
      return EventGroup::kRests;
    case core::EventKind::kImpactFloor:
    case core::EventKind::kImpactCeiling:
    case core::EventKind::kImpactWest:
    case core::EventKind::kImpactEast:
    case core::EventKind::kImpactWeight:
      break;
  }
  return EventGroup::kImpacts;
}

QString numberOf(int weight) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(weight + 1);
}

}  // namespace

bool belongsTo(EventGroup group, core::EventKind kind) {
  return group == EventGroup::kAll || group == groupOf(kind);
}

QString groupWords(EventGroup group) {
  switch (group) {
    case EventGroup::kAll:
      return Words::tr("All events");
    case EventGroup::kImpacts:
      return Words::tr("Impacts");
    case EventGroup::kTurningPoints:
      return Words::tr("Turning points");
    case EventGroup::kCuts:
      return Words::tr("Cuts");
    case EventGroup::kRopes:
      return Words::tr("Ropes slack and taut");
    case EventGroup::kRests:
      return Words::tr("Coming to rest");
  }
  return {};
}

QString eventWords(core::EventKind kind) {
  switch (kind) {
    case core::EventKind::kCut:
      return Words::tr("Cut");
    case core::EventKind::kTurningPoint:
      return Words::tr("Turning point");
    case core::EventKind::kSlack:
      return Words::tr("Rope slack");
    case core::EventKind::kTaut:
      return Words::tr("Rope taut");
    case core::EventKind::kImpactFloor:
      return Words::tr("Impact on the floor");
    case core::EventKind::kImpactCeiling:
      return Words::tr("Impact on the ceiling");
    case core::EventKind::kImpactWest:
      return Words::tr("Impact on the left wall");
    case core::EventKind::kImpactEast:
      return Words::tr("Impact on the right wall");
    case core::EventKind::kImpactWeight:
      return Words::tr("Impact of weights");
    case core::EventKind::kRest:
      return Words::tr("Comes to rest");
  }
  return {};
}

QString whoWords(const core::Event& event) {
  if (event.weight < 0) return Words::tr("all");
  if (event.other < 0) return numberOf(event.weight);
  return Words::tr("%1 and %2").arg(numberOf(event.weight), numberOf(event.other));
}

}  // namespace ui
