#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/scene/scene.h"

namespace core {

/// Places in the room where more weights like `model` can start without overlapping each
/// other or a weight of the scene: in rows, to the right of the model, then upwards, then
/// from the floor.
///
/// @param model   a weight without a rope
/// @param wanted  places to find
/// @return        centers [m]; fewer than wanted where the room is too full, none where
///                the model itself could not run in it
std::vector<Eigen::Vector2d> freePlaces(const Scene& scene, const Weight& model,
                                        std::size_t wanted);

}  // namespace core
