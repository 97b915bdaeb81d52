#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace core {

/// Samples over time in bounded memory: when full, every other sample of the whole past is
/// dropped and from then on only every second, fourth, … offered one is kept, so a run of
/// any length is covered evenly. First and latest are always there.
///
/// `Sample` has a member `time` [s] and a function `height()`, which a chart's axis must
/// have room for.
template <class Sample>
class Series {
 public:
  /// @param most  samples kept, ≥ 4
  explicit Series(std::size_t most) : m_most(most) {}

  void append(const Sample& sample);
  void clear() { *this = Series(m_most); }
  /// Forgets what came after `time` [s].
  void dropAfter(double time);

  /// In time order.
  std::span<const Sample> samples() const { return m_samples; }
  /// Greatest finite height so far, or 0. Samples that are no longer kept count, until
  /// dropAfter() forgets some.
  double highest() const { return m_highest; }

 private:
  void raiseHighest(const Sample& sample);
  void thinByHalf();

  std::size_t m_most;
  std::size_t m_stride = 1;      // offered samples per kept one
  std::size_t m_offered = 0;     // since the last kept one
  bool m_latestIsExtra = false;  // the last sample stands only until the next is offered
  double m_highest = 0;
  std::vector<Sample> m_samples;
};

template <class Sample>
void Series<Sample>::append(const Sample& sample) {
  if (m_latestIsExtra) m_samples.pop_back();
  m_latestIsExtra = false;
  if (m_samples.size() == m_most) thinByHalf();
  ++m_offered;
  if (m_samples.empty() || m_offered >= m_stride) {
    m_offered = 0;
  } else {
    m_latestIsExtra = true;
  }
  m_samples.push_back(sample);
  raiseHighest(sample);
}

template <class Sample>
void Series<Sample>::dropAfter(double time) {
  const auto end = std::ranges::upper_bound(m_samples, time, {}, &Sample::time);
  if (end == m_samples.end()) return;
  m_samples.erase(end, m_samples.end());
  m_latestIsExtra = false;
  m_offered = 0;
  m_highest = 0;
  std::ranges::for_each(m_samples, [this](const auto& sample) { raiseHighest(sample); });
}

/// Heights too large for a double would leave an axis without numbers.
template <class Sample>
void Series<Sample>::raiseHighest(const Sample& sample) {
  const double height = sample.height();
  if (std::isfinite(height)) m_highest = std::max(m_highest, height);
}

/// @pre no extra sample stands at the end
template <class Sample>
void Series<Sample>::thinByHalf() {
  // What goes with the last sample still counts as offered since the one before it.
  if (m_samples.size() % 2 == 0) m_offered += m_stride;
  for (std::size_t i = 1; 2 * i < m_samples.size(); ++i) m_samples[i] = m_samples[2 * i];
  m_samples.resize((m_samples.size() + 1) / 2);
  m_stride *= 2;
}

}  // namespace core
