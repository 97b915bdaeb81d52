#include "core/contact/first_contact.h"

namespace core {
namespace {

/// |a − b|² as a polynomial of degree 6 [m²].
Bernstein<6> squaredDistance(const Path& a, const Path& b) {
  std::array<Eigen::Vector2d, 4> apart;
  for (int i = 0; i < 4; ++i) apart[i] = a.points[i] - b.points[i];
  constexpr double kWeights[4][4] = {{1, 1. / 2, 1. / 5, 1. / 20},
                                     {1. / 2, 3. / 5, 9. / 20, 1. / 5},
                                     {1. / 5, 9. / 20, 3. / 5, 1. / 2},
                                     {1. / 20, 1. / 5, 1. / 2, 1}};
  Bernstein<6> result{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) result[i + j] += kWeights[i][j] * apart[i].dot(apart[j]);
  return result;
}

/// What follows a moment of touching: the gap opens at `opening` per u. If it starts to
/// open, or stays, only a later fall counts.
///
/// The moment is where the gap is zero by definition: what it is off by would count many
/// times over in the quotients, and weights that overlap could never part.
template <int kDegree>
std::optional<Contact> contactAfterTouching(Bernstein<kDegree> gap, double opening, bool still,
                                            double tolerance) {
  const double offset = gap[0];
  for (double& coefficient : gap) coefficient -= offset;
  Bernstein<kDegree - 1> rest = withoutRootAtZero<kDegree>(gap);
  if (!still) {
    rest[0] = opening;
    const std::optional<double> fall = firstFall<kDegree - 1>(rest, tolerance);
    return fall ? std::optional(Contact{*fall}) : std::nullopt;
  }
  // The speed is zero to within rounding, so the next order decides.
  const std::optional<double> fall =
      firstFall<kDegree - 2>(withoutRootAtZero<kDegree - 1>(rest), tolerance);
  if (!fall) return std::nullopt;
  return Contact{*fall, *fall == 0};
}

std::optional<Contact> plainContact(std::optional<double> u) {
  return u ? std::optional(Contact{*u}) : std::nullopt;
}

}  // namespace

std::optional<Contact> firstContact(const Path& a, const Path& b, double touching, double duration,
                                    const ContactTolerance& tolerance) {
  Bernstein<6> gap = squaredDistance(a, b);
  const double startDistance = std::sqrt(gap[0]);
  for (double& coefficient : gap) coefficient -= touching * touching;
  if (startDistance - touching > tolerance.gap) return plainContact(firstFall<6>(gap, 0));
  const Eigen::Vector2d apart = a.points[0] - b.points[0];
  const double speed = apart.dot(a.velocity - b.velocity) / startDistance;
  if (speed < -tolerance.speed) return Contact{0};
  return contactAfterTouching<6>(gap, 2 * startDistance * speed * duration,
                                 speed <= tolerance.speed, 2 * touching * tolerance.gap);
}

std::optional<Contact> firstWallContact(const Bernstein<3>& distance, double speed, double duration,
                                        const ContactTolerance& tolerance) {
  if (distance[0] > tolerance.gap) return plainContact(firstFall<3>(distance, 0));
  if (speed < -tolerance.speed) return Contact{0};
  return contactAfterTouching<3>(distance, speed * duration, speed <= tolerance.speed,
                                 tolerance.gap);
}

std::optional<double> firstTaut(const Path& path, const Eigen::Vector2d& pivot, double length,
                                double duration, double outwardAcceleration,
                                const ContactTolerance& tolerance) {
  const Path fixed{{pivot, pivot, pivot, pivot}, {0, 0}};
  Bernstein<6> room = squaredDistance(path, fixed);
  const double startDistance = std::sqrt(room[0]);
  for (double& coefficient : room) coefficient = length * length - coefficient;
  if (length - startDistance > tolerance.gap) return firstFall<6>(room, 0);
  const double closing = path.velocity.dot(path.points[0] - pivot) / startDistance;
  if (closing > tolerance.speed) return 0.0;
  const double rounding = 2 * length * tolerance.gap;
  Bernstein<5> rest = withoutRootAtZero<6>(room);
  if (closing < -tolerance.speed) {
    rest[0] = -2 * startDistance * closing * duration;
    return firstFall<5>(rest, rounding);
  }
  if (outwardAcceleration > 0) return 0.0;
  Bernstein<4> bending = withoutRootAtZero<5>(rest);
  bending[0] = -length * outwardAcceleration * duration * duration;
  if (bending[0] > 0) return firstFall<4>(bending, bending[0] > rounding ? 0 : rounding);
  // A rope that just went slack: neither speed nor acceleration leads away from the circle,
  // only the third order opens the rope.
  return firstFall<3>(withoutRootAtZero<4>(bending), rounding);
}

}  // namespace core
