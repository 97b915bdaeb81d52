#pragma once

#include <optional>
#include <vector>

#include <QString>
#include <QWidget>

#include "ui/view/scene_marks.h"
#include "ui/view/scene_view.h"
#include "ui/view/shown_target.h"

namespace ui {

/// The runs of a scene: all in one view, or split into one view for each run, as many side by
/// side and below each other as show the room largest. Split views have one size and see the
/// same part of the room; whoever moves one moves all.
class SceneArea : public QWidget {
  Q_OBJECT

 public:
  explicit SceneArea(QWidget* parent = nullptr);

  /// Shows these runs of one scene from now on; see SceneView::setRuns().
  void setRuns(std::vector<const core::Run*> runs);
  /// Draws the runs at this moment [s]; call once per frame.
  void showTime(double time);

  /// Opens up a step of a weight in this run; null: none.
  void showStep(const ShownStep* step, std::size_t run);

  /// Draws these over the runs in all views; see SceneView::setMarks().
  void setMarks(const SceneMarks& marks);
  const SceneMarks& marks() const { return m_marks; }
  /// @param hand  gets hold of things by mouse; must outlive the views
  void setHand(SceneHand* hand);

  /// The trails of all runs as they are shown; null while they are not, or not in one view.
  const Trails* trails() const;
  /// Shows a target on the floor, with a landing for each run; nothing: none.
  void setTarget(const std::optional<ShownTarget>& target);

  /// See SceneView; split views show the same, so that one speaks for all.
  void announce(const QString& words) { m_views.front()->announce(words); }

  bool isSplit() const { return m_split; }
  /// In the order of the runs; one for all where they are not split.
  const std::vector<SceneView*>& views() const { return m_views; }

  void setPainterChoice(PainterChoice choice);
  QString painterDescription() const { return m_views.front()->painterDescription(); }
  /// See SceneView.
  QString trailsDescription() const { return m_views.front()->trailsDescription(); }

 public slots:
  /// Gives each run a view of its own, or all of them one.
  void setSplit(bool split);
  void setTrailsShown(bool shown);
  void fitRoom() { m_views.front()->fitRoom(); }
  void zoomIn() { m_views.front()->zoomIn(); }
  void zoomOut() { m_views.front()->zoomOut(); }

 signals:
  /// Another painter draws from now on.
  void painterChanged();
  /// trailsDescription() may be another one.
  void trailsChanged();
  /// The user dragged the target.
  void targetMoved(const core::Target& target);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void distributeRuns();
  void distributeTarget();
  void setViewCount(std::size_t count);
  void addView();
  void arrange();
  void followOne(const SceneView* leader);
  int columnsFor(QSizeF room) const;

  std::vector<const core::Run*> m_runs;
  SceneMarks m_marks;
  SceneHand* m_hand = nullptr;
  std::vector<SceneView*> m_views;  // never empty; children
  PainterChoice m_choice = PainterChoice::kAutomatic;
  std::optional<ShownTarget> m_target;
  double m_time = 0;
  bool m_trailsShown = true;
  bool m_split = false;
};

}  // namespace ui
