#pragma once

#include <array>

#include <QColor>

class QPalette;

namespace ui {

/// The colors of everything that is drawn, for a light or a dark window. Curves can be told
/// apart by eyes that lack red, green or blue cones, and so can runs, of which each has a dash
/// of its own besides; curves have a contrast of at least 3:1 to the background, text of at
/// least 4.5:1. A test sees to it.
struct Theme {
  bool dark = false;
  QColor background;  ///< around the room and behind charts
  QColor room;        ///< inside the room
  QColor wall;
  QColor grid;
  QColor text;
  QColor faintText;  ///< axis numbers and notes
  QColor rope;
  QColor outline;  ///< around filled weights

  /// One for each run that can stand beside others: the first run's weights are filled in
  /// their own colors, the others are outlines in these. None is one of the colors weights
  /// have unless the user chose others, nor are two alike to color-blind eyes.
  std::array<QColor, 4> runs;

  // Curves of the energy ledger.
  QColor kinetic;
  QColor potential;
  QColor lostToAir;
  QColor lostToImpacts;
  QColor lostToRopes;
  QColor lostToFriction;
  QColor total;
  QColor drift;

  static Theme light();
  static Theme darkTheme();
  /// The one that fits a palette: dark where its window is darker than its text.
  static Theme of(const QPalette& palette);
};

}  // namespace ui
