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

/// Of a to b, in the mean of before and after [m/s].
Eigen::Vector2d meanVelocity(const RestingContact& contact, std::span<const Eigen::Vector2d> before,
                             std::span<const RestingWeight> after) {
  Eigen::Vector2d sum = before[contact.a] + after[contact.a].velocity;
  if (contact.b >= 0) sum -= before[contact.b] + after[contact.b].velocity;
  return sum / 2;
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

double pushLoss(std::span<const RestingContact> contacts, std::span<const Eigen::Vector2d> before,
                std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts)
    if (contact.push > 0)
      loss -= contact.push * contact.normal.dot(meanVelocity(contact, before, after));
  return loss;
}

double dragLoss(std::span<const RestingContact> contacts, std::span<const Eigen::Vector2d> before,
                std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts)
    if (contact.drag != 0)
      loss -= contact.drag * tangentOf(contact).dot(meanVelocity(contact, before, after));
  return loss;
}

}  // namespace core
