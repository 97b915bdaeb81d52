#pragma once

#include <optional>
#include <variant>

#include <QString>
#include <QStringList>

#include "core/scene/scene.h"

namespace app {

/// `angrycuts [SCENE]`: open the window.
struct WindowCall {
  QString scene;  ///< empty: the one of last time
};

/// `angrycuts scenes`: list the built-in scenes, or write them as files.
struct ScenesCall {
  QString folder;  ///< to write them into; empty: list them
};

/// When `simulate` or `measure` cuts all ropes, where the command line says so.
struct CutChoice {
  std::optional<double> time;  ///< [s]; nothing: never
};

/// `angrycuts simulate SCENE`: run without a window.
struct SimulateCall {
  QString scene;
  core::Solver solver;
  double until = 10;             ///< simulated time to reach [s]
  std::optional<CutChoice> cut;  ///< nothing: as the scene says
  double sample = 0.1;           ///< time between rows [s]

  // Files; empty: not wanted, "-": standard output.
  QString trajectory;
  QString energy;
  QString events;
  QString chart;  ///< never "-"
};

/// `angrycuts measure SCENE`: measure speed against accuracy.
struct MeasureCall {
  QString scene;
  double until = 10;             ///< simulated time to measure over [s]
  std::optional<CutChoice> cut;  ///< nothing: as the scene says

  // Files; empty: not wanted.
  QString csv;    ///< "-": standard output
  QString chart;  ///< never "-"
};

struct HelpCall {};
struct VersionCall {};

using Call = std::variant<WindowCall, ScenesCall, SimulateCall, MeasureCall, HelpCall, VersionCall>;

/// What the command line asks for, or one line that says what is wrong with it.
struct CallOrError {
  std::optional<Call> call;
  QString error;
};

/// @param arguments  without the program's name
CallOrError parseCall(const QStringList& arguments);

}  // namespace app
