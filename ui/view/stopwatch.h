#pragma once

#include <optional>

#include <QPointF>
#include <QRectF>

namespace ui {

class Camera;
struct Drawing;
struct SceneLook;

/// Measures simulated time. Reads what has passed between the moments at which it was started
/// and stopped, wherever in time has been gone meanwhile: started at one event and stopped at
/// another it reads just what lies between them, and going back while it runs counts back.
struct Stopwatch {
  double counted = 0;                          ///< up to the last stop [s]
  std::optional<double> since = std::nullopt;  ///< when it was started [s]; nothing: it stands
  QPointF place{1, 0};  ///< share of the way it can be moved, from the left and from above

  bool isRunning() const { return since.has_value(); }
  /// At this simulated moment [s].
  double reading(double time) const { return counted + (since ? time - *since : 0); }
  void startOrStop(double time);
  /// Reads zero from now on, running or not as before.
  void setToZero(double time);
};

/// Its face in a picture [px].
/// @param top  the face stays below this line [px]
QRectF stopwatchFace(const Stopwatch& stopwatch, double top, const Camera& camera,
                     const SceneLook& look);

/// Moves the face so that its upper left corner comes as near to `corner` [px] as it can.
void placeStopwatch(Stopwatch& stopwatch, QPointF corner, double top, const Camera& camera,
                    const SceneLook& look);

/// Adds the face, with digits that can be read from the back row.
/// @param time  simulated [s]
void drawStopwatch(const Stopwatch& stopwatch, double time, bool isChosen, double top,
                   const Camera& camera, const SceneLook& look, Drawing& drawing);

}  // namespace ui
