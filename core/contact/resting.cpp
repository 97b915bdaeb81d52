#include "core/contact/resting.h"

#include <cmath>

#include "core/contact/contact_problem.h"
#include "core/contact/contact_sweeps.h"

namespace core {
namespace {

Eigen::Vector2d tangentOf(const RestingContact& contact) {
  return {-contact.normal.y(), contact.normal.x()};
}

/// What an impulse [N s] does to the weight's velocity [m/s].
Eigen::Vector2d velocityChange(const RestingWeight& weight, const Eigen::Vector2d& impulse) {
  return freePart(weight, impulse) / weight.mass;
}

Eigen::Vector2d relativeVelocity(const RestingContact& contact,
                                 std::span<const RestingWeight> weights) {
  if (contact.b < 0) return weights[contact.a].velocity;
  return weights[contact.a].velocity - weights[contact.b].velocity;
}

}  // namespace

bool solveContacts(std::span<RestingWeight> weights, std::span<RestingContact> contacts,
                   double duration, const ContactGoal& goal) {
  ContactProblem problem(weights, contacts, duration);
  const bool solved = solveBySweeps(problem, goal);
  problem.store(weights, contacts);
  return solved;
}

void applyCarried(std::span<RestingWeight> weights, std::span<const RestingContact> contacts) {
  for (const RestingContact& contact : contacts) {
    RestingWeight& a = weights[contact.a];
    a.velocity += velocityChange(a, contact.push * contact.normal);
    a.velocity += velocityChange(a, contact.drag * tangentOf(contact));
    if (contact.b < 0) continue;
    RestingWeight& b = weights[contact.b];
    b.velocity -= velocityChange(b, contact.push * contact.normal);
  }
}

double inelasticLoss(std::span<const RestingContact> contacts,
                     std::span<const Eigen::Vector2d> before,
                     std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts) {
    if (contact.push == 0) continue;
    Eigen::Vector2d mean = before[contact.a] + after[contact.a].velocity;
    if (contact.b >= 0) mean -= before[contact.b] + after[contact.b].velocity;
    loss -= 0.5 * (contact.push * contact.normal + contact.drag * tangentOf(contact)).dot(mean);
  }
  return std::max(0.0, loss);  // rounding may leave −10⁻¹⁵ of nothing
}

double slipLoss(std::span<const RestingContact> contacts, std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts)
    loss += std::abs(contact.drag * relativeVelocity(contact, after).dot(tangentOf(contact)));
  return loss;
}

}  // namespace core
