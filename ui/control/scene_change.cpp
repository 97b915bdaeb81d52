#include "ui/control/scene_change.h"

#include <algorithm>
#include <utility>

namespace ui {
namespace {

core::Scene withoutWeights(core::Scene scene) {
  scene.weights = {};
  return scene;
}

std::size_t bytesOf(const core::Scene& rest) {
  return sizeof(core::Scene) + rest.name.capacity() + rest.description.capacity() +
         rest.solvers.capacity() * sizeof(core::Solver);
}

}  // namespace

SceneChange::SceneChange(const core::Scene& before, const core::Scene& after)
    : m_before{withoutWeights(before), {}}, m_after{withoutWeights(after), {}} {
  const std::vector<core::Weight>& old = before.weights;
  const std::vector<core::Weight>& now = after.weights;
  const auto first = std::ranges::mismatch(old, now);
  m_first = static_cast<std::size_t>(first.in1 - old.begin());
  auto oldEnd = old.end();
  auto nowEnd = now.end();
  while (oldEnd != first.in1 && nowEnd != first.in2 && *(oldEnd - 1) == *(nowEnd - 1)) {
    --oldEnd;
    --nowEnd;
  }
  m_before.weights.assign(first.in1, oldEnd);
  m_after.weights.assign(first.in2, nowEnd);
}

bool SceneChange::isEmpty() const {
  return m_before.rest == m_after.rest && m_before.weights.empty() && m_after.weights.empty();
}

std::size_t SceneChange::bytes() const {
  const std::size_t weights = m_before.weights.capacity() + m_after.weights.capacity();
  return bytesOf(m_before.rest) + bytesOf(m_after.rest) + weights * sizeof(core::Weight);
}

void SceneChange::exchange(core::Scene& scene, const Side& present, const Side& wanted) const {
  std::vector<core::Weight> weights = std::move(scene.weights);
  const auto begin = weights.begin() + static_cast<std::ptrdiff_t>(m_first);
  const auto shared = std::min(present.weights.size(), wanted.weights.size());
  const auto split = static_cast<std::ptrdiff_t>(shared);
  std::copy_n(wanted.weights.begin(), shared, begin);
  const auto rest =
      weights.erase(begin + split, begin + static_cast<std::ptrdiff_t>(present.weights.size()));
  weights.insert(rest, wanted.weights.begin() + split, wanted.weights.end());
  scene = wanted.rest;
  scene.weights = std::move(weights);
}

}  // namespace ui
