#include "ui/chart/chart_look.h"

#include <algorithm>
#include <cmath>

#include <QAbstractAxis>
#include <QChart>
#include <QFontInfo>
#include <QGuiApplication>
#include <QScreen>

namespace ui {

namespace {

constexpr double kLeastScreenPoints = 12;
constexpr double kPaperPoints = 9.5;  // as captions in books

double pixelsPerPoint() {
  const QScreen* screen = QGuiApplication::primaryScreen();
  return (screen != nullptr ? screen->logicalDotsPerInch() : 96.0) / 72;
}

}  // namespace

ChartLook ChartLook::forScreen(const Theme& theme, const QFont& font) {
  QFont sized(font);
  const double least = kLeastScreenPoints * pixelsPerPoint();
  sized.setPixelSize(
      static_cast<int>(std::ceil(std::max<double>(QFontInfo(font).pixelSize(), least))));
  return {theme, sized};
}

ChartLook ChartLook::forPaper() {
  // By its resolved name, for files are read where "Sans Serif" is another font.
  QFont font(QFontInfo(QGuiApplication::font()).family());
  font.setPixelSize(qRound(kPaperPoints / 72 * kPaperDotsPerInch));
  font.setHintingPreference(QFont::PreferNoHinting);
  Theme theme = Theme::light();
  theme.background = Qt::white;
  return {theme, font, true};
}

void applyLook(QChart& chart, const ChartLook& look) {
  chart.setBackgroundRoundness(0);
  chart.setBackgroundPen(Qt::NoPen);
  chart.setBackgroundBrush(look.theme.background);
  chart.setPlotAreaBackgroundVisible(true);
  chart.setPlotAreaBackgroundBrush(look.theme.room);
  chart.setPlotAreaBackgroundPen(Qt::NoPen);
}

void applyLook(QAbstractAxis& axis, const ChartLook& look) {
  axis.setLabelsFont(look.font);
  axis.setLabelsColor(look.theme.faintText);
  axis.setTitleFont(look.font);
  axis.setTitleBrush(look.theme.text);
  axis.setGridLinePen(QPen(look.theme.grid, 1));
  axis.setLinePen(QPen(look.theme.faintText, 1));
}

}  // namespace ui
