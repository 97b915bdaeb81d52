#include "ui/chart/curve_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

using core::TimedPoint;

void CurveExtent::add(const TimedPoint& point) {
  lowestX = std::min(lowestX, point.x);
  highestX = std::max(highestX, point.x);
  lowestY = std::min(lowestY, point.y);
  highestY = std::max(highestY, point.y);
}

void CurveExtent::add(const CurveExtent& other) {
  lowestX = std::min(lowestX, other.lowestX);
  highestX = std::max(highestX, other.highestX);
  lowestY = std::min(lowestY, other.lowestY);
  highestY = std::max(highestY, other.highestY);
}

CurveCache::CurveCache(std::shared_ptr<const PointSource> source)
    : m_source(std::move(source)), m_revision(m_source->revision()) {}

bool CurveCache::hasNews() const {
  return m_source->revision() != m_revision || m_source->size() != m_points.size() ||
         m_source->settled() != m_settled || lastHasMoved();
}

/// The last point may have been replaced by a later one.
bool CurveCache::lastHasMoved() const {
  if (m_points.empty()) return false;
  std::vector<TimedPoint> last;
  m_source->appendFrom(m_points.size() - 1, last);
  return last.front().time != m_points.back().time;
}

void CurveCache::read() {
  if (m_source->revision() != m_revision) {
    m_revision = m_source->revision();
    m_settled = m_measured = 0;
    m_extent = {};
  }
  // Behind the settled points may stand one that others have replaced.
  m_points.resize(m_settled);
  m_source->appendFrom(m_settled, m_points);
  m_measured = std::min(m_measured, m_settled);
  m_settled = m_source->settled();
}

const CurveExtent& CurveCache::extentUntil(double time) {
  if (time != m_extentUntil) {
    m_extentUntil = time;
    m_extent = {};
    m_measured = 0;
  }
  for (; m_measured < m_points.size(); ++m_measured) {
    const TimedPoint& point = m_points[m_measured];
    if (point.time > time) break;
    if (std::isfinite(point.x) && std::isfinite(point.y)) m_extent.add(point);
  }
  return m_extent;
}

std::optional<TimedPoint> CurveCache::at(double time) const {
  const auto after = std::ranges::lower_bound(m_points, time, {}, &TimedPoint::time);
  if (after == m_points.end()) return std::nullopt;
  if (after->time == time || after == m_points.begin()) {
    const bool isThere = after->time == time && std::isfinite(after->y);
    return isThere ? std::optional(*after) : std::nullopt;
  }
  const TimedPoint& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  const TimedPoint between{time, before.x + part * (after->x - before.x),
                           before.y + part * (after->y - before.y)};
  if (!std::isfinite(between.x) || !std::isfinite(between.y)) return std::nullopt;
  return between;
}

}  // namespace ui
