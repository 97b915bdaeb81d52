#pragma once

#include <QString>

namespace core {
struct Problem;
}

namespace ui {

/// The problem in one line for whoever wrote the file or the call, with its numbers as they stand
/// there, whatever the language:
/// "weights[3].rope.length: must be from 0.001 to 10000 m, got -1".
QString problemLine(const core::Problem& problem);

}  // namespace ui
