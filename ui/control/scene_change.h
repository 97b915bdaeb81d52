#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/scene.h"

namespace ui {

/// What turns one scene into another, and back.
///
/// Of the weights only the stretch of the list that differs is kept, so that a change of one
/// weight among 100,000 stays small.
class SceneChange {
 public:
  SceneChange(const core::Scene& before, const core::Scene& after);

  /// Nothing differs.
  bool isEmpty() const;
  /// Memory it takes, about.
  std::size_t bytes() const;

  /// @pre `scene` is what the change led to
  void undo(core::Scene& scene) const { exchange(scene, m_after, m_before); }
  /// @pre `scene` is what the change began with
  void redo(core::Scene& scene) const { exchange(scene, m_before, m_after); }

 private:
  struct Side {
    core::Scene rest;                   // all but the weights
    std::vector<core::Weight> weights;  // the stretch that differs
  };

  void exchange(core::Scene& scene, const Side& present, const Side& wanted) const;

  std::size_t m_first = 0;  // index where the stretch begins, on both sides
  Side m_before;
  Side m_after;
};

}  // namespace ui
