#pragma once

#include "app/exit_status.h"
#include "app/options.h"

namespace app {

/// `angrycuts measure SCENE`: measures what each method costs and how right it is, and writes
/// what was asked for. Shows its progress on standard error where that is a terminal.
/// @pre a QGuiApplication exists if a chart is wanted; it needs no display
ExitStatus runMeasure(const MeasureCall& call);

}  // namespace app
