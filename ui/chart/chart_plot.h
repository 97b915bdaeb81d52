#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <QObject>
#include <QRectF>
#include <QString>

#include "ui/chart/chart_frame.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/curve_cache.h"
#include "ui/chart/energy_extent.h"
#include "ui/chart/hidden_curves.h"

class QChart;

namespace ui {

class CurvesItem;
struct DrawnCurve;

/// One kind of chart of a subject, the same on screen and on paper. Belongs to its chart as a
/// child object.
class ChartPlot : public QObject {
  Q_OBJECT

 public:
  /// @param chart  takes ownership
  explicit ChartPlot(QChart* chart);

  void setLook(const ChartLook& look);
  /// Above the legend; shown from the next update on.
  void setTitle(const QString& title, const QString& note);
  /// A time axis that is not zoomed reaches at least to there [s]; keeps the first moments of
  /// a growing run from changing it all the time.
  void setLeastTime(double time);
  /// All curves together have at most so many points; without, each has its 2000.
  void setMostPoints(std::size_t most);

  /// What to show from now on. Another kind comes with nothing hidden and all of it; the same
  /// kind of the same scene stays as it was looked at.
  void setSubject(const ChartKind& kind, ChartSubject subject);
  const ChartKind& kind() const { return *m_kind; }
  const ChartSubject& subject() const { return m_subject; }

  void setHidden(HiddenCurves hidden);
  const HiddenCurves& hidden() const { return m_hidden; }

  /// Shows just this range, in SI units, with the lowest y as top(); nothing: all.
  void setZoom(std::optional<QRectF> zoom);
  const std::optional<QRectF>& zoom() const { return m_zoom; }
  /// What is shown without a zoom, in the same units.
  QRectF wholeRange();
  /// What is shown, in the same units.
  const QRectF& range() const { return m_range; }
  /// Taken off energies with height in them before they are drawn [J].
  double offset() const { return m_content.energies ? m_extent.offset : 0; }

  /// Whether update() would show anything new; takes no time to speak of.
  bool hasNews() const;
  /// Reads what the runs have recorded, and shows it.
  void update();

  const ChartContent& content() const { return m_content; }
  /// One for each curve of the content.
  const std::vector<CurveCache>& caches() const { return m_caches; }
  /// What is read off a curve: its own points, or its amounts.
  const CurveCache& readable(std::size_t curve) const;
  /// Whether a curve has anything to show and is not hidden.
  bool isShown(std::size_t curve) const;
  const std::vector<DrawnCurve>& drawn() const;
  /// The legend's or a run's entry at a place in the chart; null: none.
  const HeadingEntry* entryAt(QPointF place) const;

 private:
  void rebuild();
  void findShown();
  CurveExtent extentOfAll();
  void showScales();
  void showCurves();
  DrawnCurve drawnCurve(std::size_t index, std::size_t most) const;
  QRectF withEqualUnits(QRectF range) const;

  ChartFrame* m_frame;   // belongs to the chart
  CurvesItem* m_curves;  // belongs to the chart
  QChart* m_chart;       // the parent
  const ChartKind* m_kind;
  ChartSubject m_subject;
  ChartContent m_content;
  std::vector<CurveCache> m_caches;
  std::vector<std::optional<CurveCache>> m_amounts;  // where they are not the points
  std::vector<bool> m_hasValues;                     // one for each curve
  GrowingEnergyExtent m_growing;
  EnergyExtent m_extent;
  HiddenCurves m_hidden;
  std::optional<QRectF> m_zoom;
  QRectF m_range{0, 0, 1, 1};
  AxisScale m_horizontal;
  AxisScale m_vertical;
  QString m_title;
  QString m_note;
  double m_leastTime = 0;
  std::size_t m_mostPoints = std::numeric_limits<std::size_t>::max();
};

}  // namespace ui
