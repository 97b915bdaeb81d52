#pragma once

namespace core {

/// Whether windows can be opened here, as far as the surroundings tell.
bool hasScreen();

}  // namespace core
