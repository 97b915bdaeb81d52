#pragma once

#include <cstdint>
#include <optional>

#include <QObject>
#include <QPointF>

#include "core/aim/target.h"

class QMouseEvent;

namespace ui {

class SceneView;

/// Lets the mouse drag the target of a view along the floor: its middle moves it, an end of it
/// makes it wider or narrower. What happens elsewhere in the view is left to others.
class TargetHandle : public QObject {
  Q_OBJECT

 public:
  /// @param view  whose target it is, and the parent
  explicit TargetHandle(SceneView* view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// The user wants the target to be there, within the room.
  void moved(const core::Target& target);

 private:
  enum class Part : std::uint8_t { kMiddle, kWestEnd, kEastEnd };

  std::optional<Part> partAt(QPointF pixel) const;
  bool press(const QMouseEvent& event);
  bool drag(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void showCursor(QPointF pixel);
  double rounded(double metres) const;

  SceneView* m_view;
  std::optional<Part> m_dragged;
  core::Target m_before;  // when it was taken hold of
  double m_takenAt = 0;   // x [m]
  bool m_hasCursor = false;
};

}  // namespace ui
