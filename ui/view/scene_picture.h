#pragma once

#include <optional>
#include <vector>

#include <QSize>
#include <QString>

#include "ui/view/scene_marks.h"
#include "ui/view/shown_target.h"

namespace core {
class Run;
}

namespace ui {

class Trails;

/// The size of a picture unless another is chosen [px].
inline constexpr QSize kScenePictureSize(1200, 900);

/// What is drawn besides the runs themselves.
struct PicturedMarks {
  SceneMarks marks = {};           ///< the selected weight is not marked: nobody can move it
  const Trails* trails = nullptr;  ///< of these runs; null: none
  std::optional<ShownTarget> target = std::nullopt;  ///< with a landing for each run
};

/// Draws the runs at one moment into a file, with no display needed: a light picture for
/// paper, in PNG, SVG or PDF by the file's ending. Never leaves a half-written file.
///
/// @param runs    of one scene, the first filled, the others as outlines
/// @param time    [s], inside the latest step of every run
/// @param size    of the picture in px at 96 dpi; PNG is written at twice that
/// @return        empty, or what went wrong in words, without the file's name
QString writeScenePicture(const QString& file, const std::vector<const core::Run*>& runs,
                          double time, QSize size = kScenePictureSize,
                          const PicturedMarks& pictured = {});

}  // namespace ui
