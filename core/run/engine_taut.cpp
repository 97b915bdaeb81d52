#include <algorithm>
#include <cmath>
#include <numbers>

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

/// Of two angles the one nearer to a third, all in rad and taken around the circle.
double nearer(double one, double other, double angle) {
  const auto away = [angle](double candidate) {
    return std::abs(std::remainder(candidate - angle, 2 * std::numbers::pi));
  };
  return away(one) <= away(other) ? one : other;
}

/// The angle nearest to `angle` at which a point at `length` from the origin lies at least
/// `distance` from `obstacle`; the angle itself if it does, or if none does.
double beside(double angle, double length, const Eigen::Vector2d& obstacle, double distance) {
  const Eigen::Vector2d place(length * std::sin(angle), -length * std::cos(angle));
  if ((place - obstacle).norm() >= distance || obstacle.norm() == 0) return angle;
  const double away = obstacle.norm();
  const double cosine = (length * length + away * away - distance * distance) / (2 * length * away);
  if (std::abs(cosine) > 1) return angle;
  const double toObstacle = std::atan2(obstacle.x(), -obstacle.y());
  const double turn = std::acos(cosine);
  return nearer(toObstacle + turn, toObstacle - turn, angle);
}

/// The angle nearest to `angle` at which length · sin(angle − from) ≥ lowest; the angle itself
/// if it does, or if none does.
double inside(double angle, double length, double from, double lowest) {
  if (length * std::sin(angle - from) >= lowest || std::abs(lowest) > length) return angle;
  const double turn = std::asin(lowest / length);
  return nearer(from + turn, from + std::numbers::pi - turn, angle);
}

}  // namespace

double Engine::clearAngle(int index, double s, double angle) {
  // What one obstacle pushes the weight into shows in the next round.
  constexpr int kRounds = 4;
  const Body& body = m_bodies[index];
  const double halfPi = 0.5 * std::numbers::pi;
  const Room& room = m_scene->room;
  for (int round = 0; round < kRounds; ++round) {
    const double before = angle;
    angle = inside(angle, body.length, 0, body.radius - body.pivot.x());
    angle = inside(angle, body.length, 2 * halfPi, body.pivot.x() + body.radius - room.width);
    angle = inside(angle, body.length, halfPi, body.radius - body.pivot.y());
    angle = inside(angle, body.length, -halfPi, body.pivot.y() + body.radius - room.height);
    const Eigen::Vector2d place =
        body.pivot + body.length * Eigen::Vector2d(std::sin(angle), -std::cos(angle));
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(body.radius);
    m_broadPhase.forEachNear({place - margin, place + margin}, [&](int other) {
      if (other == index) return;
      const Piece& piece = pieceAt(other, s);
      const Eigen::Vector2d there = positionOf(m_bodies[other], piece.mode, piece.at(s));
      angle = beside(angle, body.length, there - body.pivot, body.radius + m_bodies[other].radius);
    });
    if (angle == before) break;
  }
  return angle;
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
    // Around the circle: the clear one may be told a whole turn away.
    const double aside = std::remainder(clearAngle(i, s, angle) - angle, 2 * std::numbers::pi);
    // No farther than it moves in a step, or has moved to get there: all around may be something.
    const double farthest = std::max(kFarthestAside * std::sqrt(2 * body.length * off),
                                     velocity.norm() * m_solver.step);
    if (std::abs(aside) * body.length <= farthest) placed = angle + aside;
  }
  Entries after;
  after << placed, 0, velocity.dot(track) / body.length, 0, before[4];
  log(EventKind::kTaut, s, i, readOut(i, piece.mode, true, before),
      readOut(i, Mode::kSwing, true, after), 0.5 * body.mass * jerk * jerk);
  goOn(i, s, before, Mode::kSwing, after);
}

}  // namespace core
