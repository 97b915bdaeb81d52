#pragma once

#include <string>

namespace core {
struct Scene;
}

namespace ui {

/// The scene as JSON text that SceneReader reads back to an equal scene, one weight a line.
/// @param scene  its numbers are finite, its texts valid UTF-8
std::string writtenScene(const core::Scene& scene);

}  // namespace ui
