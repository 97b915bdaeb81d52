#pragma once

#include <optional>

#include <QObject>
#include <QPointF>
#include <QRectF>

#include "ui/chart/chart_overlay.h"

class QChart;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace ui {

class ChartPlot;

/// What mouse, wheel and keys do in a chart: zoom and move it, read values, pick a moment, hide
/// curves and runs. Places are in the chart [px].
class ChartHand : public QObject {
  Q_OBJECT

 public:
  /// @param chart  holds the plot; both must outlive the hand
  ChartHand(QChart* chart, ChartPlot* plot, QObject* parent = nullptr);

  const ChartOverlay& overlay() const { return m_overlay; }
  void showTime(double time);
  void zoomIn();
  void zoomOut();
  void resetZoom();

  /// @return  whether the press means anything here
  bool press(const QMouseEvent& event);
  void move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void pressAgain(const QMouseEvent& event);
  void turnWheel(const QWheelEvent& event);
  /// The pointer is elsewhere, or the chart another one.
  void stopReading();

  bool wants(const QKeyEvent& event) const;
  /// @pre wants(event)
  void pressKey(const QKeyEvent& event);

 signals:
  /// The plot shows another range or other curves.
  void plotChanged();
  void overlayChanged();
  void cursorWanted(Qt::CursorShape shape);
  /// The user chose a moment [s].
  void timePicked(double time);

 private:
  /// What the mouse does while a button is down.
  enum class Drag { kNone, kTime, kBox, kMove };

  /// Where the curves are.
  QRectF plotArea() const;
  void zoomTo(const QRectF& range);
  void zoomAt(QPointF place, double factorX, double factorY);
  void finishBox();
  void toggleEntryAt(QPointF place);
  void pickAt(QPointF place);
  void readAt(QPointF place);
  void feel(QPointF place);
  bool isOnTimeLine(QPointF place) const;
  std::optional<double> timeAt(QPointF place) const;
  QPointF valuesAt(QPointF place) const;

  QChart* m_chart;
  ChartPlot* m_plot;
  ChartOverlay m_overlay;
  Drag m_drag = Drag::kNone;
  QPointF m_dragStart;
  QRectF m_rangeAtStart;
};

}  // namespace ui
