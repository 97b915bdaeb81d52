#include "ui/chart/log_frame.h"

#include <algorithm>
#include <utility>

#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QXYSeries>

namespace ui {
namespace {

// In multiples of the font's size.
constexpr double kPadding = 0.7;
constexpr double kLabelWidth = 5;
constexpr double kLabelHeight = 1.8;
constexpr QSizeF kAxes(6, 4);

void showScale(QCategoryAxis& axis, const LogScale& scale, const QString& title) {
  for (const QString& label : axis.categoriesLabels()) axis.remove(label);
  axis.setRange(scale.lowest, scale.highest);
  axis.setStartValue(scale.lowest);
  // Qt leaves no room between labels and title.
  const QChar gap(QChar::Nbsp);
  for (const LogScale::Tick& tick : scale.ticks) axis.append(gap + tick.label, tick.place);
  axis.setTitleText(title);
}

}  // namespace

LogFrame::LogFrame(QChart* chart)
    : QObject(chart),
      m_chart(chart),
      m_horizontal(addAxis(Qt::AlignBottom)),
      m_vertical(addAxis(Qt::AlignLeft)),
      m_heading(new ChartHeading(chart)) {
  chart->legend()->hide();
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  // Else the chart keeps the size that a heading in a narrower chart made it need.
  chart->setMinimumSize(1, 1);
  connect(chart, &QChart::geometryChanged, this, [this] {
    layOut();
    emit resized();
  });
}

QCategoryAxis* LogFrame::addAxis(Qt::Alignment side) {
  auto* axis = new QCategoryAxis;
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  m_chart->addAxis(axis, side);
  return axis;
}

void LogFrame::setLook(const ChartLook& look) {
  m_look = look;
  applyLook(*m_chart, look);
  applyLook(*m_horizontal, look);
  applyLook(*m_vertical, look);
  m_heading->setLook(look);
  layOut();
}

void LogFrame::setHeading(HeadingContent content) {
  m_heading->setContent(std::move(content));
  layOut();
}

void LogFrame::setHorizontal(const LogScale& scale, const QString& title) {
  showScale(*m_horizontal, scale, title);
}

void LogFrame::setVertical(const LogScale& scale, const QString& title) {
  showScale(*m_vertical, scale, title);
}

void LogFrame::add(QXYSeries* series) {
  m_chart->addSeries(series);
  series->attachAxis(m_horizontal);
  series->attachAxis(m_vertical);
}

void LogFrame::removeCurves() {
  m_chart->removeAllSeries();
}

int LogFrame::horizontalLabels() const {
  const double em = m_look.font.pixelSize();
  return std::max(2,
                  static_cast<int>((m_chart->size().width() / em - kAxes.width()) / kLabelWidth));
}

int LogFrame::verticalLabels() const {
  const double em = m_look.font.pixelSize();
  const double height = m_chart->size().height() - m_chart->margins().top();
  return std::max(2, static_cast<int>((height / em - kAxes.height()) / kLabelHeight));
}

void LogFrame::layOut() {
  const int padding = qRound(kPadding * m_look.font.pixelSize());
  m_heading->setPos(padding, padding);
  const double height = m_heading->layOut(m_chart->size().width() - 2 * padding);
  // On the right half a label stands out over the last tick.
  const QMargins margins(padding, qRound(height) + 3 * padding / 2, 2 * padding, padding);
  if (m_chart->margins() != margins) m_chart->setMargins(margins);
}

}  // namespace ui
