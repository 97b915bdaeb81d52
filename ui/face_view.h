#pragma once

#include <map>
#include <optional>

#include <QByteArray>

#include "ui/control/commands.h"
#include "ui/help/help_window.h"
#include "ui/panels/charts_panel.h"

namespace ui {

/// How the user has left the widgets of a window, for those in another language to go on with.
struct FaceView {
  QByteArray panels;  ///< as QMainWindow::saveState() gives them
  std::map<Command, bool> switches;
  ChartsView charts;
  std::optional<QByteArray> trade;  ///< place of the window for speed and accuracy, if it is open
  std::optional<QByteArray>
      whenToCut;  ///< place of the window for the moment to cut, if it is open
  std::optional<HelpWindow::Place> help;  ///< if it is open
};

}  // namespace ui
