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

/// What follows a moment of touching: `gap` starts at zero by definition. If it starts to
/// open, or stays, only a later fall counts.
template <int kDegree>
std::optional<Contact> contactAfterTouching(const Bernstein<kDegree>& gap, bool still,
                                            double tolerance) {
  const Bernstein<kDegree - 1> opening = withoutRootAtZero<kDegree>(gap);
  if (!still) {
    const std::optional<double> fall = firstFall<kDegree - 1>(opening, 0);
    return fall ? std::optional(Contact{*fall}) : std::nullopt;
  }
  // The speed is zero to within rounding, so the next order decides.
  const Bernstein<kDegree - 2> bending = withoutRootAtZero<kDegree - 1>(opening);
  const std::optional<double> fall = firstFall<kDegree - 2>(bending, tolerance);
  if (!fall) return std::nullopt;
  return Contact{*fall, *fall == 0};
}

}  // namespace

std::optional<Contact> firstContact(const Path& a, const Path& b, double touching, double duration,
                                    const ContactTolerance& tolerance) {
  Bernstein<6> gap = squaredDistance(a, b);
  const double squaredTouching = touching * touching;
  const double startDistance = std::sqrt(gap[0]);
  for (double& coefficient : gap) coefficient -= squaredTouching;
  if (startDistance - touching > tolerance.gap) {
    const std::optional<double> fall = firstFall<6>(gap, 0);
    return fall ? std::optional(Contact{*fall}) : std::nullopt;
  }
  // d(distance)/du = (d(squared distance)/du) / (2 distance).
  const double opening = 3 * (gap[1] - gap[0]) / startDistance;
  const double still = tolerance.speed * duration;
  if (opening < -still) return Contact{0};
  return contactAfterTouching<6>(gap, opening <= still, 2 * touching * tolerance.gap);
}

std::optional<Contact> firstWallContact(const Bernstein<3>& distance, double duration,
                                        const ContactTolerance& tolerance) {
  if (distance[0] > tolerance.gap) {
    const std::optional<double> fall = firstFall<3>(distance, 0);
    return fall ? std::optional(Contact{*fall}) : std::nullopt;
  }
  const double opening = 3 * (distance[1] - distance[0]);
  const double still = tolerance.speed * duration;
  if (opening < -still) return Contact{0};
  return contactAfterTouching<3>(distance, opening <= still, tolerance.gap);
}

std::optional<double> firstTaut(const Path& path, const Eigen::Vector2d& pivot, double length,
                                double duration, double outwardAcceleration,
                                const ContactTolerance& tolerance) {
  const Path fixed{{pivot, pivot, pivot, pivot}};
  Bernstein<6> room = squaredDistance(path, fixed);
  const double startDistance = std::sqrt(room[0]);
  for (double& coefficient : room) coefficient = length * length - coefficient;
  if (length - startDistance > tolerance.gap) return firstFall<6>(room, 0);
  const double closing = 3 * (room[0] - room[1]) / startDistance;
  const double still = tolerance.speed * duration;
  if (closing > still) return 0.0;
  if (closing < -still) return firstFall<5>(withoutRootAtZero<6>(room), 0);
  if (outwardAcceleration > 0) return 0.0;
  Bernstein<4> bending = withoutRootAtZero<5>(withoutRootAtZero<6>(room));
  bending[0] = -length * outwardAcceleration * duration * duration;
  if (bending[0] > 2 * length * tolerance.gap) return firstFall<4>(bending, 0);
  // A rope that just went slack: neither speed nor acceleration leads away from the circle,
  // only the third order opens the rope.
  return firstFall<3>(withoutRootAtZero<4>(bending), 2 * length * tolerance.gap);
}

}  // namespace core
