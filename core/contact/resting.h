#pragma once

#include <span>

#include <Eigen/Core>

namespace core {

/// A weight in lasting contact, for the solver below.
struct RestingWeight {
  Eigen::Vector2d velocity{0, 0};  ///< [m/s]; the solver changes it
  double mass = 1;                 ///< [kg]
  /// Unit vector it can only move along, for a weight on a taut rope; zero if it is free.
  Eigen::Vector2d track{0, 0};
};

/// [J]
inline double kineticEnergy(const RestingWeight& weight) {
  return 0.5 * weight.mass * weight.velocity.squaredNorm();
}

/// Two weights, or a weight and a surface, that touch or may touch soon.
struct RestingContact {
  int a = -1;                    ///< index of the weight the normal points at
  int b = -1;                    ///< index of the other weight; −1 for a surface
  Eigen::Vector2d normal{0, 0};  ///< unit vector from b (or the surface) to a
  double gap = 0;                ///< between the edges [m]; negative where they overlap
  double friction = 0;           ///< μ of a surface, 0 between weights [-]
  double push = 0;               ///< impulse along the normal so far [N s], ≥ 0
  double drag = 0;               ///< impulse along (−n_y, n_x) so far [N s], |drag| ≤ μ push
};

/// Where the search for contact impulses ends.
struct ContactGoal {
  double tolerance;  ///< no contact would change its weights' approach by more [m/s], > 0
  int mostSweeps;    ///< over all contacts, ≥ 1: a bound on the work, where that is not small
};

/// Finds the contact impulses that keep weights apart for a stretch of time, all together,
/// and gives them to the weights.
///
/// At each contact either the impulse is zero or the gap is used up at the end of the
/// stretch: push ≥ 0, v_n + gap/duration ≥ 0, and one of the two is zero. As weights that
/// move along straight lines only come closer than that to each other if v_n falls short
/// of −gap/duration, none overlaps on its way, touching or not. On surfaces with friction
/// the tangential impulse stops the slip or is μ push.
///
/// The search starts from the impulses the contacts carry, which the weights' velocities
/// must hold already.
///
/// @param weights   indices in the contacts refer to these
/// @param duration  of the stretch [s], > 0
/// @return          false if the bound on the work ended it, or more work would be in vain
bool solveContacts(std::span<RestingWeight> weights, std::span<RestingContact> contacts,
                   double duration, const ContactGoal& goal);

/// Gives the impulses the contacts carry to the weights.
void applyCarried(std::span<RestingWeight> weights, std::span<const RestingContact> contacts);

/// What the pushes of solved contacts take from weights that had the velocities `before`:
/// −Σ push (v_n before + v_n after)/2 [J].
double pushLoss(std::span<const RestingContact> contacts, std::span<const Eigen::Vector2d> before,
                std::span<const RestingWeight> after);

/// What friction on surfaces takes: −Σ drag (v_t before + v_t after)/2 [J].
double dragLoss(std::span<const RestingContact> contacts, std::span<const Eigen::Vector2d> before,
                std::span<const RestingWeight> after);

}  // namespace core
