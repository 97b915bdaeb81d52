#pragma once

#include <QImage>
#include <QSize>

#include "ui/style/theme.h"

namespace core {
struct Scene;
}

namespace ui {

/// A small picture of a scene as its runs show it after some time: the room, ropes, weights
/// and trails, without words. Computes the runs for it.
///
/// @param time              [s], ≥ 0; a run that stops earlier is shown where it stopped
/// @param size              logical px
/// @param devicePixelRatio  of the screen it is for
/// @pre problemsIn(scene) is empty; it has at least one solver, all of known methods
QImage scenePreview(const core::Scene& scene, double time, QSize size, double devicePixelRatio,
                    const Theme& theme);

}  // namespace ui
