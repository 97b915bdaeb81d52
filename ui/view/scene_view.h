#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QString>
#include <QWidget>

#include "ui/style/theme.h"

namespace core {
class Run;
struct Room;
}  // namespace core

namespace ui {

class Camera;
class SceneHand;
class SceneMouse;
class Trails;
struct SceneLook;
struct SceneMarks;
struct ShownScene;
struct ShownStep;
struct ShownTarget;

/// Which painter draws the scene.
enum class PainterChoice {
  kAutomatic,  ///< OpenGL 3.3 where it is real hardware, else QPainter
  kOpenGl,     ///< OpenGL 3.3 wherever it works, software too
  kQPainter,
};

/// The room with its weights, ropes and trails. Draws runs; computes no physics.
///
/// The wheel zooms at the pointer, dragging pans, a double click fits the room, unless the hand
/// takes hold of what lies there.
class SceneView : public QWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// Shows these runs of one scene from now on, the first with filled weights, the others
  /// as outlines. Forgets all trails; fits the room when its size is another one than
  /// before. The runs must outlive the view or the next call.
  /// @param firstPlace  of the first of them among all runs of the scene
  void setRuns(std::vector<const core::Run*> runs, std::size_t firstPlace = 0);

  /// Draws the runs at this moment; call once per frame.
  /// @param time  [s], inside the latest step of every run
  void showTime(double time);

  /// Forgets the trails, for jumps in time.
  void clearTrails();
  void setTrailsShown(bool shown);
  /// What many weights cost the trails, in words for the status bar; empty: nothing.
  QString trailsDescription() const;
  /// The trails as they are shown, for a picture; null while they are not.
  const Trails* trails() const;

  /// Opens up a step of one weight over the scene; null: none.
  void showStep(const ShownStep* step);

  /// Draws these over the runs from now on, until the next call.
  void setMarks(const SceneMarks& marks);
  /// @param hand  gets hold of things by mouse; must outlive the view
  void setHand(SceneHand* hand);
  /// What is drawn, and how.
  const ShownScene& shown() const;
  const SceneLook& look() const;
  /// Shows a target on the floor; nothing: none.
  void setTarget(const std::optional<ShownTarget>& target);
  /// Null while none is shown.
  const ShownTarget* target() const;
  /// Of the scene that is shown.
  const core::Room& room() const;

  void setPainterChoice(PainterChoice choice);
  /// The part of the room that is seen.
  const Camera& camera() const;
  /// True until the user chooses another part than the whole room.
  bool isFitted() const;
  /// Sees what another view of the same scene and size sees.
  void follow(const SceneView& other);

  /// Tells screen readers that something happened.
  void announce(const QString& words);
  const QString& announcement() const { return m_announcement; }

  /// What draws now, in words for the status bar: "OpenGL 4.5 (llvmpipe)" or "QPainter
  /// (software OpenGL would be slower)".
  QString painterDescription() const;

 public slots:
  void fitRoom();
  /// Moves what is seen by so many pixels.
  void panBy(QPointF pixels);
  /// Enlarges or shrinks the picture around its middle, as two notches of the wheel do.
  void zoomIn();
  void zoomOut();

 signals:
  /// Another painter draws from now on, by choice or because OpenGL was lost.
  void painterChanged();
  /// The user chose another part of the room to see.
  void cameraMoved();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  void nameParts();

  class Content;
  std::unique_ptr<Content> m_content;
  std::unique_ptr<SceneMouse> m_mouse;
  QString m_announcement;
};

}  // namespace ui
