#pragma once

#include <vector>

#include <QSize>
#include <QString>

namespace core {
class Run;
}

namespace ui {

class Trails;
struct ShownTarget;

/// The size of a picture unless another is chosen [px].
inline constexpr QSize kScenePictureSize(1200, 900);

/// Draws the runs at one moment into a file, with no display needed: a light picture for
/// paper, in PNG, SVG or PDF by the file's ending. Never leaves a half-written file.
///
/// @param runs    of one scene, the first filled, the others as outlines
/// @param time    [s], inside the latest step of every run
/// @param size    of the picture in px at 96 dpi; PNG is written at twice that
/// @param trails  of these runs, drawn too; null: none
/// @param target  on the floor, with a landing for each run; null: none
/// @return        empty, or what went wrong in words
QString writeScenePicture(const QString& file, const std::vector<const core::Run*>& runs,
                          double time, QSize size = kScenePictureSize,
                          const Trails* trails = nullptr, const ShownTarget* target = nullptr);

}  // namespace ui
