#pragma once

#include <vector>

#include <QString>

namespace core {
struct Problem;
}

namespace ui {

/// The problem as a sentence for whoever set up the scene; weights count from 1.
QString problemWords(const core::Problem& problem);

/// The first problem, and how many more there are, as one sentence.
/// @pre `problems` is not empty
QString problemWords(const std::vector<core::Problem>& problems);

}  // namespace ui
