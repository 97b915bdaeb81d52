#pragma once

#include <QObject>
#include <QPointF>

#include "ui/view/measuring_tools.h"

namespace ui {

class SceneView;

/// The tools for measuring in the scene. They stay where they are put, whatever time does; what
/// is put away comes back where it was.
class ToolBox : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// What lies on the scene.
  const MeasuringTools& tools() const { return m_tools; }

  // Lays a tool on the scene, where it lay before, or in the middle of what the view shows.
  void showTape(bool shown, const SceneView& view);
  void showProtractor(bool shown, const SceneView& view);
  void showStopwatch(bool shown);

  /// What lies there.
  std::optional<ToolPart> partAt(const SceneView& view, QPointF pixel) const;
  /// What is moved from now on.
  void choose(std::optional<ToolPart> part);
  /// Goes to the next part of the tools; after the last one to none.
  void chooseNext();
  /// Takes hold of the chosen part.
  void begin(const SceneView& view, QPointF pixel);
  /// Leads it to the pointer.
  /// @param snaps  to the nearest pivot or weight, else to a grid
  void drag(const SceneView& view, QPointF pixel, bool snaps);
  /// Moves it by one step.
  void moveBy(double x, double y, const SceneView& view);

  /// @param time  simulated [s]
  void startOrStop(double time);
  void setToZero(double time);
  /// Time starts anew: a watch that runs starts with it.
  void restart();

 signals:
  /// tools() are not what they were.
  void changed();

 private:
  MeasuringTools m_tools;
  // As they were put away.
  std::optional<MeasuringTape> m_tape;
  std::optional<Protractor> m_protractor;
  std::optional<Stopwatch> m_stopwatch;
  QPointF m_offset;  // from the pointer to what it leads [px]
};

}  // namespace ui
