#pragma once

#include <array>

#include <QString>

#include "core/run/event.h"

namespace ui {

/// Kinds of events that belong together, to be listed or gone to.
enum class EventGroup { kAll, kImpacts, kTurningPoints, kCuts, kRopes, kRests };

inline constexpr std::array kEventGroups = {EventGroup::kAll,           EventGroup::kImpacts,
                                            EventGroup::kTurningPoints, EventGroup::kCuts,
                                            EventGroup::kRopes,         EventGroup::kRests};

bool belongsTo(EventGroup group, core::EventKind kind);

/// "Impacts"
QString groupWords(EventGroup group);
/// "Impact on the floor"
QString eventWords(core::EventKind kind);
/// The weights it happened to, counted from 1 as everywhere in the window: "3", "3 and 5",
/// "all".
QString whoWords(const core::Event& event);

}  // namespace ui
