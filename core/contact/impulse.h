#pragma once

#include <Eigen/Core>

namespace core {

/// What the collision law needs to know about one weight.
struct CollidingWeight {
  Eigen::Vector2d velocity;  ///< of the center [m/s]
  double mass;               ///< [kg]
  /// Unit vector it can only move along, for a weight on a taut rope; zero if it is free.
  Eigen::Vector2d track{0, 0};

  /// 1/M along a unit vector n [1/kg]: 1/m for a free weight, (t·n)²/m on a track t.
  double inverseMass(const Eigen::Vector2d& n) const;
  /// Change of the velocity when an impulse J n acts [m/s].
  Eigen::Vector2d velocityChange(double impulse, const Eigen::Vector2d& n) const;
};

/// Impulse two smooth weights exchange when they touch.
///
/// Newton's restitution law along the line of centers; no friction between weights. The
/// impulse acts on a as −J n and on b as +J n.
///
/// @param normal       n: unit vector from a to b
/// @param restitution  e: speed after / speed before, 0 to 1 [-]
/// @return             J ≥ 0 [N s]; 0 if they already move apart, or neither can give way
/// @pre |normal| = 1, 0 ≤ restitution ≤ 1
/// Derivation and energy loss: core/model.md, "Impacts".
double collisionImpulse(const CollidingWeight& a, const CollidingWeight& b,
                        const Eigen::Vector2d& normal, double restitution);

/// Energy that impulse turns into heat [J], ≥ 0: ½ (1 − e²) v_n² / (1/M_a + 1/M_b).
double collisionLoss(const CollidingWeight& a, const CollidingWeight& b,
                     const Eigen::Vector2d& normal, double restitution);

/// A free weight's velocity after it hit a wall, floor or ceiling, and what that took.
struct WallImpact {
  Eigen::Vector2d velocity;  ///< after [m/s]
  double energyLost;         ///< [J], ≥ 0, friction's part included
};

/// The normal speed v_n turns into e |v_n|; the tangential speed loses
/// min(μ (1 + e) |v_n|, |v_t|).
///
/// @param velocity  before [m/s]
/// @param mass      [kg]
/// @param inward    unit vector from the wall into the room
/// @return          unchanged if the weight already moves away from the wall
/// @pre |inward| = 1
/// Derivation: core/model.md, "Impacts".
WallImpact wallImpact(const Eigen::Vector2d& velocity, double mass, const Eigen::Vector2d& inward,
                      double restitution, double friction);

}  // namespace core
