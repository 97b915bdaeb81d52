#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// Samples in time order, in bounded memory: when full, every other sample of the whole past
/// is dropped and from then on only every second, fourth, … offered one is kept, so a run of
/// any length is covered evenly. First and latest are always there.
///
/// What reads it again and again need not begin anew: the first settled() samples stay as
/// they are for as long as revision() does.
///
/// @tparam Sample  has a member `time` [s]
template <class Sample>
class EvenSeries {
 public:
  /// @param most  samples kept, ≥ 4
  explicit EvenSeries(std::size_t most) : m_most(most) { assert(most >= 4); }

  void append(const Sample& sample) {
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
  }

  void clear() {
    const std::uint64_t revision = m_revision + 1;
    *this = EvenSeries(m_most);
    m_revision = revision;
  }

  /// Forgets what came after `time` [s].
  /// @return  whether there was anything
  bool dropAfter(double time) {
    const auto end = std::ranges::upper_bound(m_samples, time, {}, &Sample::time);
    if (end == m_samples.end()) return false;
    m_samples.erase(end, m_samples.end());
    m_latestIsExtra = false;
    m_offered = 0;
    ++m_revision;
    return true;
  }

  std::span<const Sample> samples() const { return m_samples; }
  std::size_t settled() const { return m_samples.size() - (m_latestIsExtra ? 1 : 0); }
  std::uint64_t revision() const { return m_revision; }

 private:
  /// @pre no extra sample stands at the end
  void thinByHalf() {
    // What goes with the last sample still counts as offered since the one before it.
    if (m_samples.size() % 2 == 0) m_offered += m_stride;
    for (std::size_t i = 1; 2 * i < m_samples.size(); ++i) m_samples[i] = m_samples[2 * i];
    m_samples.erase(m_samples.begin() + static_cast<std::ptrdiff_t>((m_samples.size() + 1) / 2),
                    m_samples.end());
    m_stride *= 2;
    ++m_revision;
  }

  std::size_t m_most;
  std::size_t m_stride = 1;      // offered samples per kept one
  std::size_t m_offered = 0;     // since the last kept one
  bool m_latestIsExtra = false;  // the last sample stands only until the next is offered
  std::uint64_t m_revision = 0;
  std::vector<Sample> m_samples;
};

}  // namespace core
