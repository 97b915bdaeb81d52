#pragma once

#include "core/scene/scene.h"

namespace tests {

/// Equal discs of 2 cm on a square lattice that fills a box at packing 0.3, with velocities up to
/// 0.5 m/s in each direction, always the same ones; restitution 0.8, no friction.
/// @param columns  of the lattice; 0: as many as rows, or one more
core::Scene crowd(int count, int columns = 0);

}  // namespace tests
