#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ui/chart/chart_curve.h"

namespace ui {

/// What points span; empty while lowestX > highestX.
struct CurveExtent {
  double lowestX = std::numeric_limits<double>::infinity();
  double highestX = -std::numeric_limits<double>::infinity();
  double lowestY = std::numeric_limits<double>::infinity();
  double highestY = -std::numeric_limits<double>::infinity();

  bool isEmpty() const { return lowestX > highestX; }
  void add(const core::TimedPoint& point);
  void add(const CurveExtent& other);
};

/// The points of one curve at hand: reads only what is new.
class CurveCache {
 public:
  explicit CurveCache(std::shared_ptr<const PointSource> source);

  /// Whether read() would find anything new; takes no time to speak of.
  bool hasNews() const;
  void read();

  /// In order of time, as of the last read().
  std::span<const core::TimedPoint> points() const { return m_points; }

  /// Of all finite points up to a moment [s].
  const CurveExtent& extentUntil(double time);

  /// The point at a moment, between two samples by straight line; nothing before the first,
  /// after the last, and in gaps.
  std::optional<core::TimedPoint> at(double time) const;

 private:
  bool lastHasMoved() const;

  std::shared_ptr<const PointSource> m_source;
  std::vector<core::TimedPoint> m_points;
  std::size_t m_settled = 0;
  std::uint64_t m_revision = 0;

  CurveExtent m_extent;
  double m_extentUntil = std::numeric_limits<double>::infinity();
  std::size_t m_measured = 0;  // points in the extent
};

}  // namespace ui
