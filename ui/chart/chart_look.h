#pragma once

#include <QFont>

#include "ui/style/theme.h"

class QAbstractAxis;
class QChart;

namespace ui {

/// Resolution at which charts for paper are laid out: lines of 2 px are 1 pt thick.
inline constexpr int kPaperDotsPerInch = 150;

/// Colors and type of a chart.
struct ChartLook {
  Theme theme = Theme::light();
  QFont font;  ///< of axis numbers and legend, with its size in px
  /// Axes keep their titles where height is scarce, too: on paper nothing else says what they are.
  bool keepsTitles = false;

  /// For the screen: a widget's font, at 12 pt or more.
  static ChartLook forScreen(const Theme& theme, const QFont& font);
  /// For paper: light, with a font that scales without steps.
  static ChartLook forPaper();
};

void applyLook(QChart& chart, const ChartLook& look);
void applyLook(QAbstractAxis& axis, const ChartLook& look);

}  // namespace ui
