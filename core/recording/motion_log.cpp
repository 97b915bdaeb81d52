#include "core/recording/motion_log.h"

#include <algorithm>
#include <cassert>

namespace core {

namespace {

constexpr std::size_t kMostSamples = 40000;        // of one weight
constexpr std::size_t kMostOfAllWeights = 300000;  // about 25 MB

std::size_t samplesForEach(int weights) {
  const auto count = static_cast<std::size_t>(std::clamp(weights, 1, MotionLog::kMostFromStart));
  return std::min(kMostSamples, kMostOfAllWeights / count);
}

}  // namespace

void MotionLog::start(const Run& run) {
  m_tracks.clear();
  const int count = std::min(run.weightCount(), kMostFromStart);
  for (int i = 0; i < count; ++i) m_tracks.emplace(i, Track(samplesForEach(count)));
  append(run);
}

void MotionLog::append(const Run& run) {
  for (auto& [weight, track] : m_tracks) track.append({run.time(), run.weight(weight)});
}

void MotionLog::dropAfter(double time) {
  for (auto& [weight, track] : m_tracks) track.dropAfter(time);
}

void MotionLog::follow(int weight, const std::vector<MotionSample>& past) {
  assert(track(weight) == nullptr);
  Track& track = m_tracks.emplace(weight, Track(samplesForEach(kMostFromStart))).first->second;
  for (const MotionSample& sample : past) track.append(sample);
}

const MotionLog::Track* MotionLog::track(int weight) const {
  const auto found = m_tracks.find(weight);
  return found == m_tracks.end() ? nullptr : &found->second;
}

}  // namespace core
