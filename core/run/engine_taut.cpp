#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "core/run/engine.h"

// How a slack rope goes taut. The straight paths of Euler's methods leave the circle a little
// before the rope pulls, so the weight is put back on it; where something stands there by now,
// beside that.

namespace core {
namespace {

// Share of a rope's length.
constexpr double kOffCircle = 1e-9;
// Multiple of the way along a tangent that leads so far off the circle.
constexpr double kFarthestAside = 2;

/// The angles less than `half` away from `middle`, in rad and taken around the circle.
struct Arc {
  double middle;
  double half;

  double farFrom(double angle) const {
    return std::abs(std::remainder(angle - middle, 2 * std::numbers::pi)) - half;
  }
};

/// Where a point at `length` from the origin lies nearer than `distance` to `obstacle`. Nothing
/// where no or every place on the circle does: there is no clear one to be told from others.
std::optional<Arc> blockedBy(const Eigen::Vector2d& obstacle, double distance, double length) {
  const double away = obstacle.norm();
  if (away == 0) return std::nullopt;
  const double cosine = (length * length + away * away - distance * distance) / (2 * length * away);
  if (std::abs(cosine) > 1) return std::nullopt;
  return Arc{std::atan2(obstacle.x(), -obstacle.y()), std::acos(cosine)};
}

/// Where length · sin(angle − from) < lowest; nothing where no or every angle is such.
std::optional<Arc> blockedBy(double from, double lowest, double length) {
  if (std::abs(lowest) > length) return std::nullopt;
  return Arc{from - 0.5 * std::numbers::pi, 0.5 * std::numbers::pi + std::asin(lowest / length)};
}

/// The angle nearest to `angle` outside of every arc, no farther from it than `reach`; the angle
/// itself where there is none.
double outside(const std::vector<Arc>& arcs, double angle, double reach) {
  // rad: the end of an arc is outside of it.
  constexpr double kRounding = 1e-12;
  const auto isClear = [&arcs](double candidate) {
    return std::ranges::all_of(
        arcs, [candidate](const Arc& arc) { return arc.farFrom(candidate) >= -kRounding; });
  };
  if (isClear(angle)) return angle;
  double best = angle;
  double nearest = reach;
  for (const Arc& arc : arcs) {
    for (const double end : {arc.middle - arc.half, arc.middle + arc.half}) {
      const double aside = std::remainder(end - angle, 2 * std::numbers::pi);
      if (std::abs(aside) > nearest || !isClear(end)) continue;
      best = angle + aside;
      nearest = std::abs(aside);
    }
  }
  return best;
}

}  // namespace

double Engine::clearAngle(int index, double s, double angle, double reach) {
  const Body& body = m_bodies[index];
  const double halfPi = 0.5 * std::numbers::pi;
  const Room& room = m_scene->room;
  std::vector<Arc> arcs;
  const auto add = [&arcs](const std::optional<Arc>& arc) {
    if (arc) arcs.push_back(*arc);
  };
  add(blockedBy(0, body.radius - body.pivot.x(), body.length));
  add(blockedBy(2 * halfPi, body.pivot.x() + body.radius - room.width, body.length));
  add(blockedBy(halfPi, body.radius - body.pivot.y(), body.length));
  add(blockedBy(-halfPi, body.pivot.y() + body.radius - room.height, body.length));
  const Eigen::Vector2d place =
      body.pivot + body.length * Eigen::Vector2d(std::sin(angle), -std::cos(angle));
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(body.radius + reach * body.length);
  m_broadPhase.forEachNear({place - margin, place + margin}, [&](int other) {
    if (other == index) return;
    const Piece& piece = pieceAt(other, s);
    const Eigen::Vector2d there = positionOf(m_bodies[other], piece.mode, piece.at(s));
    add(blockedBy(there - body.pivot, body.radius + m_bodies[other].radius, body.length));
  });
  return outside(arcs, angle, reach);
}

void Engine::goTaut(const Upcoming& event) {
  const int i = event.weight;
  const Body& body = m_bodies[i];
  const Piece piece = m_moving[i].piece;
  const auto spare = [&](double at) {
    const Entries state = m_stepper.partial(body, piece, at);
    return body.length - (positionOf(body, piece.mode, state) - body.pivot).norm();
  };
  Entries before = piece.at(event.time);
  double s = event.time;
  if (s > piece.begin) {
    const Eigen::Vector2d out = positionOf(body, piece.mode, before) - body.pivot;
    const Eigen::Vector2d rate = piece.rateAt(s).head<2>().transpose();
    const auto exact = polished(event, piece.begin, piece.end, -rate.dot(out) / out.norm(),
                                polishTolerance(), spare);
    if (exact) {
      s = *exact;
      if (mustWait(event, s)) return;
      before = m_stepper.partial(body, piece, s);
    }
  }
  const Eigen::Vector2d out = positionOf(body, piece.mode, before) - body.pivot;
  const Eigen::Vector2d radial = out.normalized();
  const Eigen::Vector2d track(-radial.y(), radial.x());
  const Eigen::Vector2d velocity = velocityOf(body, piece.mode, before);
  const double jerk = velocity.dot(radial);
  // Euler's path has left the circle by more than the rounding of places.
  const double angle = std::atan2(out.x(), -out.y());
  const double off = out.norm() - body.length;
  double placed = angle;
  if (off > kOffCircle * body.length) {
    // No farther than it moves in a step, or has moved to get there: all around may be something.
    const double farthest = std::max(kFarthestAside * std::sqrt(2 * body.length * off),
                                     velocity.norm() * m_solver.step);
    placed = clearAngle(i, s, angle, farthest / body.length);
  }
  Entries after;
  after << placed, 0, velocity.dot(track) / body.length, 0, before[4];
  log(EventKind::kTaut, s, i, readOut(i, piece.mode, true, before),
      readOut(i, Mode::kSwing, true, after), 0.5 * body.mass * jerk * jerk);
  goOn(i, s, before, Mode::kSwing, after);
}

}  // namespace core
