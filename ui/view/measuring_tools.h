#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "ui/view/measuring_tape.h"
#include "ui/view/protractor.h"
#include "ui/view/stopwatch.h"

namespace ui {

/// What a hand can take hold of at the tools.
enum class ToolPart { kTapeFrom, kTapeTo, kTape, kVertex, kFirstArm, kSecondArm, kStopwatch };

/// The tools that lie on the scene, each where it was put.
struct MeasuringTools {
  std::optional<MeasuringTape> tape = std::nullopt;
  std::optional<Protractor> protractor = std::nullopt;
  std::optional<Stopwatch> stopwatch = std::nullopt;
  std::optional<ToolPart> chosen = std::nullopt;  ///< what keys move
};

/// What there is to take hold of, in the order in which keys go through it.
std::vector<ToolPart> partsOf(const MeasuringTools& tools);

/// The part at this pixel; ends come before the whole they belong to.
/// @param top  of the tools that have their place in the picture, see drawTools() [px]
std::optional<ToolPart> toolPartAt(const MeasuringTools& tools, QPointF pixel, double top,
                                   const Camera& camera, const SceneLook& look);

/// Where the part is [px]: what a hand that holds it moves.
/// @pre the tool lies on the scene
QPointF placeOf(const MeasuringTools& tools, ToolPart part, double top, const Camera& camera,
                const SceneLook& look);

/// Moves the part there, the tape as a whole and the protractor by its vertex.
/// @pre the tool lies on the scene
void movePart(MeasuringTools& tools, ToolPart part, QPointF pixel, double top, const Camera& camera,
              const SceneLook& look);

/// Adds all tools over everything else.
/// @param time  simulated [s]
/// @param top   below this line the picture is free of words [px]
void drawTools(const MeasuringTools& tools, double time, double top, const Camera& camera,
               const SceneLook& look, Drawing& drawing);

}  // namespace ui
