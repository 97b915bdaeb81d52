#pragma once

#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include "ui/chart/chart_export.h"
#include "ui/chart/chart_plot.h"
#include "ui/style/theme.h"

class QChart;
class QGraphicsScene;

namespace ui {

class ChartHand;

/// A chart to look at closely: zoom by wheel, by keys or by drawing a box; move it; read values
/// under the pointer; hide curves and runs by clicking on them in the legend; pick a moment by
/// clicking or dragging the time line. Draws recordings; computes no physics.
class ChartWidget : public QWidget {
  Q_OBJECT

 public:
  explicit ChartWidget(QWidget* parent = nullptr);
  ~ChartWidget() override;

  /// What to show from now on; what it points to must outlive the widget or the next call.
  void setSubject(const ChartKind& kind, ChartSubject subject);

  /// Redraws if there is anything new; call at most once per frame, it limits itself.
  void refresh();
  /// Puts the time line, or dots on the curves, there.
  /// @param time  the moment that all views show [s]
  void showTime(double time);

  const ChartPlot& plot() const { return *m_plot; }
  /// Where the curves are [px].
  QRectF plotArea() const;
  /// The chart as it is looked at, for paper.
  ChartPicture picture() const;

  void setHidden(HiddenCurves hidden);

 public slots:
  void zoomIn();
  void zoomOut();
  void resetZoom();
  /// As a picture for paper.
  void copyPicture() const;
  /// As a table that spreadsheets take.
  void copyData();

 signals:
  /// The user chose a moment [s].
  void timePicked(double time);
  /// The user wants the chart's menu, there on the screen.
  void menuRequested(QPoint place);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void applyLook();
  void paintFocus(QPainter& painter) const;
  void draw();
  void markChanged();
  void renderPicture();
  void showCursor(Qt::CursorShape shape);

  std::unique_ptr<QGraphicsScene> m_scene;
  QChart* m_chart;    // owned by the scene
  ChartPlot* m_plot;  // belongs to the chart
  ChartHand* m_hand;
  Theme m_theme;
  QPixmap m_picture;  // the chart without what moves over it
  bool m_pictureIsCurrent = false;
  QElapsedTimer m_sinceDrawn;
  double m_updateTime = 0;  // of the last update [ms]
  double m_paintTime = 0;   // of the last picture [ms]
  QTimer m_catchUp;
};

}  // namespace ui
