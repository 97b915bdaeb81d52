#pragma once

#include <QPointF>
#include <Qt>

namespace ui {

class SceneView;

/// What the mouse can do to the things in a view besides moving the view.
class SceneHand {
 public:
  /// What became of a press of the button.
  enum class Touch {
    kNothing,  ///< nothing lies there
    kTouched,  ///< something that cannot be moved now: moving on moves the view
    kHeld,     ///< something that moves along from now on
  };

  virtual ~SceneHand() = default;

  virtual Touch touch(const SceneView& view, QPointF pixel) = 0;
  /// The pointer moves what it holds.
  virtual void drag(const SceneView& view, QPointF pixel, Qt::KeyboardModifiers modifiers) = 0;
  /// The button is released over what was touched, even if that is nothing.
  /// @param moved  whether the pointer was moved meanwhile, be it only the view
  virtual void release(Touch touch, bool moved) = 0;
  /// What a press there would do.
  virtual Touch feel(const SceneView& view, QPointF pixel) const = 0;
};

}  // namespace ui
