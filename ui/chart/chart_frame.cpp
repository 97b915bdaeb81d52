#include "ui/chart/chart_frame.h"

#include <algorithm>
#include <utility>

#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLocale>
#include <QValueAxis>

namespace ui {

namespace {

QString labelFormat(const NiceScale& ticks) {
  return QStringLiteral("%.%1f").arg(ticks.decimals());
}

QString unitSuffix(const ScaledUnit& unit) {
  return unit.symbol == QStringLiteral("°") ? unit.symbol : ' ' + unit.symbol;
}

/// From tick to tick.
void showWhole(QValueAxis& axis, const NiceScale& scale, const QString& title) {
  axis.setTickType(QValueAxis::TicksFixed);
  axis.setLabelFormat(labelFormat(scale));
  axis.setTickCount(scale.tickCount());
  axis.setRange(scale.lowest, scale.highest);
  axis.setTitleText(title);
}

/// Between ticks, as a zoom leaves it.
void showPart(QValueAxis& axis, const AxisScale& scale, const QString& title) {
  axis.setLabelFormat(labelFormat(scale.ticks));
  axis.setTitleText(title);
  // In this order, or for a moment there would be millions of ticks.
  axis.setTickType(QValueAxis::TicksFixed);
  axis.setRange(scale.lowest, scale.highest);
  axis.setTickAnchor(0);
  axis.setTickInterval(scale.ticks.step);
  axis.setTickType(QValueAxis::TicksDynamic);
}

/// @param isShort  with the unit at each number in place of a title
void showScale(QValueAxis& axis, const AxisScale& scale, const QString& quantity, bool isShort) {
  const QString title = isShort ? QString() : scale.title(quantity);
  const bool endsOnTicks =
      scale.lowest == scale.ticks.lowest && scale.highest == scale.ticks.highest;
  if (endsOnTicks) {
    showWhole(axis, scale.ticks, title);
  } else {
    showPart(axis, scale, title);
  }
  if (isShort) axis.setLabelFormat(labelFormat(scale.ticks) + unitSuffix(scale.unit));
}

// Around everything, in multiples of the font's size.
constexpr double kPadding = 0.7;
// Of a heading beside the plot, in the same unit.
constexpr double kWidthBeside = 20;
// Of a plot with its axes that has no line to spare, in the same unit.
constexpr double kLow = 12;
constexpr double kLowOnPaper = 10;
constexpr double kTooLow = 5;

}  // namespace

ChartFrame::ChartFrame(QChart* chart)
    : QObject(chart),
      m_chart(chart),
      m_horizontal(addAxis(Qt::AlignBottom)),
      m_vertical(addAxis(Qt::AlignLeft)),
      m_heading(new ChartHeading(chart)) {
  chart->legend()->hide();
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  // Else the chart keeps the size that a heading in a narrower chart made it need.
  chart->setMinimumSize(1, 1);
  chart->setLocalizeNumbers(true);
  chart->setLocale(QLocale());
  connect(chart, &QChart::geometryChanged, this, [this] {
    layOut();
    emit resized();
  });
}

QValueAxis* ChartFrame::addAxis(Qt::Alignment side) {
  auto* axis = new QValueAxis;
  m_chart->addAxis(axis, side);
  return axis;
}

void ChartFrame::setLook(const ChartLook& look) {
  m_look = look;
  applyLook(*m_chart, look);
  applyLook(*m_horizontal, look);
  applyLook(*m_vertical, look);
  m_heading->setLook(look);
  layOut();
}

void ChartFrame::setHeading(HeadingContent content) {
  m_heading->setContent(std::move(content));
  layOut();
}

void ChartFrame::setHorizontal(const AxisScale& scale, const QString& quantity) {
  // Where height is scarce the unit at each number saves a line.
  showScale(*m_horizontal, scale, quantity, m_isLow);
}

void ChartFrame::setVertical(const AxisScale& scale, const QString& quantity) {
  const double title = QFontMetricsF(m_look.font).horizontalAdvance(scale.title(quantity));
  const double needed = title + m_look.font.pixelSize();  // with some room at its ends
  showScale(*m_vertical, scale, quantity, m_isLow && needed > plotSize().height());
}

int ChartFrame::horizontalIntervals() const {
  constexpr double kLabel = 5.5;  // in multiples of the font's size, with room beside it
  const double labels = plotSize().width() / (kLabel * m_look.font.pixelSize());
  return std::clamp(static_cast<int>(labels), 1, 10);
}

int ChartFrame::verticalIntervals() const {
  constexpr double kLabel = 2.2;
  const double labels = plotSize().height() / (kLabel * m_look.font.pixelSize());
  return std::clamp(static_cast<int>(labels), 1, 8);
}

/// From what stands around the plot.
QSizeF ChartFrame::plotSize() const {
  const QSizeF axes(5, m_isLow ? 2.4 : 4);  // in multiples of the font's size
  const QMarginsF margins = m_chart->margins();
  return m_chart->size().shrunkBy(margins) - axes * m_look.font.pixelSize();
}

void ChartFrame::layOut() {
  m_isLow = true;
  if (putHeadingBeside(HeadingDensity::kFull) || putHeadingBeside(HeadingDensity::kCompact)) return;
  const int em = m_look.font.pixelSize();
  const double left = m_chart->size().height() - putHeadingAbove();
  m_isLow = left < (m_look.keepsTitles ? kLowOnPaper : kLow) * em;
  if (left >= kTooLow * em) return;
  // The scene tells the runs and weights, too.
  if (putHeadingBeside(HeadingDensity::kLegend) || putHeadingBeside(HeadingDensity::kCut)) return;
  putHeadingAbove();
}

/// Where the chart is wide and low its height belongs to the plot.
/// @return  whether there is room
bool ChartFrame::putHeadingBeside(HeadingDensity density) {
  constexpr double kWide = 2.4;   // of the height
  constexpr double kShare = 0.4;  // of the width, at most
  const int em = m_look.font.pixelSize();
  const QSizeF size = m_chart->size();
  if (size.width() < kWide * size.height()) return false;
  const int pad = padding();
  const double width = std::min(kShare * size.width(), kWidthBeside * em);
  const double height = m_heading->layOut(width, density, size.height() - 2 * pad);
  if (height + 2 * pad > size.height()) return false;
  m_heading->setPos(size.width() - width - pad, pad);
  setMargins({pad, 3 * pad / 2, qRound(width) + 3 * pad, pad});
  return true;
}

/// @return  the height it takes [px]
double ChartFrame::putHeadingAbove() {
  const int pad = padding();
  m_heading->setPos(pad, pad);
  const double height = m_heading->layOut(m_chart->size().width() - 2 * pad);
  // On the right half a label stands out over the last tick.
  setMargins({pad, qRound(height) + 3 * pad / 2, 2 * pad, pad});
  return height;
}

void ChartFrame::setMargins(const QMargins& margins) {
  if (m_chart->margins() != margins) m_chart->setMargins(margins);
}

int ChartFrame::padding() const {
  return qRound(kPadding * m_look.font.pixelSize());
}

}  // namespace ui
