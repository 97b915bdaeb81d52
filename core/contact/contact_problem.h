#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/contact/resting.h"

namespace core {

/// The part of a direction the weight can move along.
Eigen::Vector2d freePart(const RestingWeight& weight, const Eigen::Vector2d& direction);

/// One contact in the solver's terms. Its approach is u = n·(v_a − v_b) + gap/duration, and
/// solved it has push ≥ 0, u ≥ 0, and one of the two zero.
struct PushRow {
  Eigen::Vector2d normalA;    ///< v_a's part in u: the normal, or its part along a's track
  Eigen::Vector2d normalB;    ///< −v_b's part in u; zero for a surface
  Eigen::Vector2d responseA;  ///< of v_a to 1 N s [1/kg]
  Eigen::Vector2d responseB;  ///< of −v_b to 1 N s [1/kg]
  double gapSpeed;            ///< gap/duration [m/s]
  double compliance;          ///< of u: its change by 1 N s [1/kg]
  double stiffness;           ///< 1/compliance; 0 where nothing can give way [kg]
  double push;                ///< [N s]
  double change;              ///< of push in the latest sweep [N s]
  double direction;           ///< of push, conjugate to those before [N s]
  int a;                      ///< index of a weight
  int b;  ///< index of a weight; for a surface, of the one past the last, which never moves
};

/// @param weights   indices in the contact refer to these
/// @param duration  of the stretch [s], > 0
PushRow pushRow(const RestingContact& contact, std::span<const RestingWeight> weights,
                double duration);

/// Sets the push of one contact right, as the others are, for the velocities of its weights.
inline void settle(PushRow& row, Eigen::Vector2d& a, Eigen::Vector2d& b) {
  const double approach = row.normalA.dot(a) - row.normalB.dot(b) + row.gapSpeed;
  const double pushed = std::max(0.0, row.push - approach * row.stiffness);
  row.change = pushed - row.push;
  row.push = pushed;
  a += row.change * row.responseA;
  b -= row.change * row.responseB;
}

/// Has the last word on a weight's approach to a surface, however large its push has become: of
/// that, rounding may take more than the weight has momentum.
inline void keepInside(PushRow& row, Eigen::Vector2d& velocity) {
  Eigen::Vector2d surface(0, 0);
  settle(row, velocity, surface);
  const double approach = row.normalA.dot(velocity) + row.gapSpeed;
  if (approach >= 0) return;
  row.push -= approach * row.stiffness;
  velocity -= approach * row.stiffness * row.responseA;
}

/// The friction at one contact with a surface: solved it has |drag| ≤ μ push, and either no
/// slip or drag at that bound against it.
struct DragRow {
  Eigen::Vector2d tangent;   ///< v_a's part in the slip
  Eigen::Vector2d response;  ///< of v_a to 1 N s [1/kg]
  double compliance;         ///< of the slip [1/kg]
  double stiffness;          ///< 1/compliance [kg]
  double friction;           ///< μ [-]
  double drag;               ///< [N s]
  double change;             ///< as in PushRow
  double direction;          ///< as in PushRow
  int a;                     ///< index of a weight
  int push;                  ///< index of its PushRow
};

/// Weights and contacts of a group, laid out for sweeps over all contacts.
struct ContactProblem {
  ContactProblem(std::span<const RestingWeight> weights, std::span<const RestingContact> contacts,
                 double duration);
  /// Velocities and impulses, back to where they came from.
  void store(std::span<RestingWeight> weights, std::span<RestingContact> contacts) const;

  std::vector<Eigen::Vector2d> velocities;  ///< of the weights, and one that is always zero
  std::vector<PushRow> pushes;  ///< in an order in which neighbours in memory rarely touch
  std::vector<DragRow> drags;
  std::vector<int> contactOf;  ///< of pushes: index of the contact
};

}  // namespace core
