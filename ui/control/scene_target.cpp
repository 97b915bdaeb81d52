#include "ui/control/scene_target.h"

#include <algorithm>

namespace ui {
namespace {

core::Target firstPlace(const core::Room& room) {
  return {0.75 * room.width, 0.1 * room.width};
}

}  // namespace

SceneTarget::SceneTarget(const core::Scene& scene, QObject* parent)
    : QObject(parent),
      m_place(firstPlace(scene.room)),
      m_weightCount(static_cast<int>(scene.weights.size())) {}

void SceneTarget::fitInto(const core::Scene& scene) {
  m_weightCount = static_cast<int>(scene.weights.size());
  const double width = scene.room.width;
  const bool fits = m_place.center <= width && m_place.width <= width;
  // In a room that is far wider it could not be seen.
  const bool isSeen = m_place.width >= 1e-3 * width;
  setPlace(fits && isSeen ? m_place : firstPlace(scene.room));
  setWeight(std::clamp(m_weight, 0, std::max(0, m_weightCount - 1)));
}

void SceneTarget::setShown(bool shown) {
  if (shown == m_isShown) return;
  m_isShown = shown;
  emit changed();
}

void SceneTarget::setPlace(const core::Target& place) {
  if (place == m_place) return;
  m_place = place;
  emit changed();
}

void SceneTarget::setWeight(int index) {
  if (index == m_weight || index < 0 || index >= std::max(1, m_weightCount)) return;
  m_weight = index;
  emit changed();
}

}  // namespace ui
