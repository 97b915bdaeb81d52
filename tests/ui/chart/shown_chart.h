#pragma once

#include <utility>
#include <vector>

#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include "tests/ui/chart/recorded_scene.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_widget.h"
#include "ui/chart/curves_item.h"

/// A chart on the screen, and what a hand and an eye do with it.
namespace shown_chart {

/// The curve as it is drawn; null: it is not.
inline const ui::DrawnCurve* curveNamed(const ui::ChartWidget& chart, const QString& name,
                                        std::size_t run = 0) {
  for (const ui::DrawnCurve& curve : chart.plot().drawn()) {
    if (curve.name == name && curve.run == run) return &curve;
  }
  return nullptr;
}

inline QPolygonF pointsOf(const ui::ChartWidget& chart, const QString& name, std::size_t run = 0) {
  QPolygonF points;
  for (const QPolygonF& line : curveNamed(chart, name, run)->lines) points += line;
  return points;
}

/// A chart on the screen, as it redraws only where it is seen.
class ShownChart : public ui::ChartWidget {
 public:
  explicit ShownChart(QSize size = QSize(640, 400)) {
    resize(size);
    show();
  }

  void setRuns(std::vector<ui::ChartedRun> runs) {
    setSubject(ui::energyChartKind(), {std::move(runs), nullptr, {}});
    grab();  // lays it out
  }

  void show(RecordedScene& scene, int kind, std::vector<int> weights) {
    setSubject(ui::chartKinds()[kind], scene.subject(std::move(weights)));
    grab();
  }
  using ui::ChartWidget::show;

  QRectF shown() const { return plot().range(); }

  /// Where values are on the widget [px].
  QPoint placeOf(QPointF values) const {
    return ui::plotTransform(shown(), plotArea()).map(values).toPoint();
  }
};

inline void turnWheel(ui::ChartWidget& chart, QPointF place, int notches,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(place, chart.mapToGlobal(place), QPoint(), QPoint(0, 120 * notches),
                    Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&chart, &event);
}

inline void drag(ui::ChartWidget& chart, QPoint from, QPoint to,
                 Qt::MouseButton button = Qt::LeftButton,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QTest::mousePress(&chart, button, modifiers, from);
  for (const QPoint place : {from + (to - from) / 2, to}) {
    QMouseEvent move(QEvent::MouseMove, place, chart.mapToGlobal(place), Qt::NoButton, button,
                     modifiers);
    QCoreApplication::sendEvent(&chart, &move);
  }
  QTest::mouseRelease(&chart, button, modifiers, to);
}

/// A place on the legend's or a run's entry with this text.
inline QPoint placeOfEntry(const ui::ChartWidget& chart, const QString& text) {
  for (int y = 0; y < chart.height(); y += 4) {
    for (int x = 0; x < chart.width(); x += 4) {
      const ui::HeadingEntry* entry = chart.plot().entryAt(QPointF(x, y));
      if (entry != nullptr && entry->text == text) return {x, y};
    }
  }
  qFatal("no entry %s", qPrintable(text));
}

}  // namespace shown_chart
