#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QPointF>
#include <QStringList>

#include "core/scene/scene.h"
#include "ui/control/words.h"
#include "ui/view/arrow_scale.h"

namespace ui {

class RunController;
class SceneEditor;
class SceneView;
class Selection;

/// Moves the selected weight of the scene, by mouse or by steps: a weight on a rope by angle or
/// length, a free one by place, both by the velocity they set out with.
///
/// A hand moves weights where they start, so only while the start is shown and time stands; steps
/// work at any moment, as a number typed into a form does. What cannot run stays a draft.
class WeightMover : public QObject {
  Q_OBJECT

 public:
  /// What of a weight the hand holds.
  enum class Grip { kBody, kVelocity };

  WeightMover(SceneEditor* editor, const Selection* selection, const RunController* controller,
              QObject* parent = nullptr);

  /// Whether a hand could move weights now.
  bool isAllowed() const;
  /// What of the selected weight lies at this pixel.
  std::optional<Grip> gripAt(const SceneView& view, QPointF pixel) const;

  /// Takes hold of the selected weight.
  /// @pre isAllowed(), and a weight is selected
  void begin(Grip grip, const SceneView& view, QPointF pixel);
  void drag(const SceneView& view, QPointF pixel, Qt::KeyboardModifiers modifiers);
  void end();
  /// Lets go, and puts the weight back where it was.
  void cancel();
  bool isDragging() const { return m_held.has_value(); }

  /// The selected weight in the draft; null: none.
  const core::Weight* weight() const;
  /// What the weight was set to last, until something else is done.
  const QStringList& words() const { return m_words; }

 public slots:
  // By one step; see nudge() and nudgeVelocity(). Nothing happens while no weight is selected.
  void moveBy(double x, double y);
  void accelerateBy(double x, double y);
  void forgetWords();

 signals:
  /// words() or isDragging() are not what they were.
  void changed();

 private:
  using Edit = std::function<void(core::Weight&)>;

  /// What is held since when.
  struct Held {
    Grip grip;
    int weight;
    core::Weight before;
    QPointF offset;  // from the pointer to what it leads [px]
    ArrowScales scales;
  };

  void change(const Edit& edit, const Words& words, const QString& mergeKey);
  void say(const QStringList& words);
  QStringList problems() const;

  SceneEditor* m_editor;
  const Selection* m_selection;
  const RunController* m_controller;
  std::optional<Held> m_held;
  QStringList m_words;
};

}  // namespace ui
