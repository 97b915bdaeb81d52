#pragma once

#include <vector>

#include <QBrush>
#include <QGraphicsItem>
#include <QPen>
#include <QPolygonF>

class QChart;

namespace ui {

/// One curve ready to be painted, in SI units: cut to the range shown.
struct DrawnCurve {
  QString name;  ///< in the legend
  std::size_t run = 0;
  bool dense = false;  ///< swings too often for a broad, smooth line to be painted in time
  QPen pen;            ///< of its line; Qt::NoPen: none
  std::vector<QPolygonF> lines;
  QBrush fill;           ///< of its areas; Qt::NoBrush: none
  bool hatched = false;  ///< lines across its areas, in the color of its pen
  std::vector<QPolygonF> areas;
};

/// The curves in a chart's plot: first what is filled, later ones below earlier ones, then
/// what is hatched, then lines. Qt's own series paint solid lines piece by piece, which takes
/// longer and shows at bends.
class CurvesItem : public QGraphicsItem {
 public:
  explicit CurvesItem(QChart* chart);

  /// @param range  what the plot shows, in the units of the curves; its top() is the lowest y
  void setCurves(std::vector<DrawnCurve> curves, const QRectF& range);
  const std::vector<DrawnCurve>& curves() const { return m_curves; }

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QChart* m_chart;  // the parent
  std::vector<DrawnCurve> m_curves;
  QRectF m_range{0, 0, 1, 1};
};

/// From what a plot shows, lowest y at top(), to where it does [px].
QTransform plotTransform(const QRectF& range, const QRectF& plot);

/// The same line with fewer points: none of those left out lies further than `tolerance` from
/// it (Douglas and Peucker).
QPolygonF simplified(const QPolygonF& line, double tolerance);

/// Slanted lines across an area, `spacing` apart, for painters without patterns.
/// @param direction  1: rising to the right, −1: falling
std::vector<QLineF> hatchLines(const QPolygonF& area, double spacing, int direction);

}  // namespace ui
