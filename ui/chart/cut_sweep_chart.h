#pragma once

#include <optional>

#include "ui/chart/cut_sweep_plot.h"
#include "ui/chart/trade_view.h"

namespace ui {

/// The chart of a sweep for hands: what stands under the pointer is read off beside it, a click
/// picks a cut time.
class CutSweepChart : public TradeView<CutSweepPlot> {
  Q_OBJECT

 public:
  explicit CutSweepChart(QWidget* parent = nullptr);

  void setResult(std::shared_ptr<const CutSweepResult> result);

 signals:
  /// The user clicked at this cut time [s]: the exact best moment of a hit where one is near.
  void momentPicked(double cutTime);

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  std::optional<double> timeAt(QPointF pixel) const;
  const core::Hit* hitNear(QPointF pixel) const;
  const core::Landing* landingAt(double time) const;
  QStringList readings(const core::Landing& landing) const;

  std::optional<QPointF> m_pointer;  // [px]
};

}  // namespace ui
