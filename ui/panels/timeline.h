#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "ui/panels/timeline_marks.h"

namespace ui {

class EventNavigator;
class RunController;
struct Theme;

/// What is recorded, from the start to as far as it is computed, with signs for the events of
/// one run and the moment shown. Pressing or dragging shows another moment; pressing on a sign
/// shows its event. While it is dragged time stands still.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  /// Both must outlive the timeline.
  Timeline(RunController* controller, const EventNavigator* events, QWidget* parent = nullptr);

  QSize sizeHint() const override;

  /// Where a moment lies [px from the left].
  double positionOf(double time) const;
  /// Height at which signs of this kind stand [px from the top].
  double rowOf(core::EventKind kind) const;
  /// What lies there, in words.
  QString wordsAt(QPointF position) const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  double timeAt(double position) const;
  double lastTime() const;
  QRectF track() const;
  const std::vector<TimelineMark>& marks() const;
  const core::Event* eventNear(QPointF position) const;
  void paintTrack(QPainter& painter, const Theme& theme) const;
  void paintBeginOfEvents(QPainter& painter, const Theme& theme) const;
  void paintEnds(QPainter& painter, const Theme& theme) const;
  void paintMoment(QPainter& painter, const Theme& theme) const;

  /// What the marks were chosen for.
  struct MarksKey {
    const void* log = nullptr;
    std::uint64_t revision = 0;
    std::size_t eventCount = 0;
    double apart = 0;

    bool operator==(const MarksKey&) const = default;
  };

  RunController* m_controller;
  const EventNavigator* m_events;
  bool m_isDragged = false;
  bool m_playsAfterDrag = false;
  mutable MarksKey m_marksKey;
  mutable std::vector<TimelineMark> m_marks;
};

}  // namespace ui
