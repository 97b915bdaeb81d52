#include "core/contact/resting.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

Eigen::Vector2d tangentOf(const RestingContact& contact) {
  return {-contact.normal.y(), contact.normal.x()};
}

Eigen::Vector2d relativeVelocity(const RestingContact& contact,
                                 std::span<const RestingWeight> weights) {
  if (contact.b < 0) return weights[contact.a].velocity;
  return weights[contact.a].velocity - weights[contact.b].velocity;
}

}  // namespace

ContactSolver::ContactSolver(std::vector<RestingWeight>& weights,
                             std::vector<RestingContact>& contacts)
    : m_weights(weights), m_contacts(contacts) {
  m_compliance.reserve(contacts.size());
  for (const RestingContact& contact : contacts) {
    const double other = contact.b < 0 ? 0 : inverseMass(weights[contact.b], contact.normal);
    m_compliance.push_back(inverseMass(weights[contact.a], contact.normal) + other);
  }
}

void ContactSolver::push(RestingWeight& weight, double impulse, const Eigen::Vector2d& direction) {
  if (weight.track.isZero(0)) {
    weight.velocity += impulse / weight.mass * direction;
  } else {
    weight.velocity += impulse / weight.mass * weight.track.dot(direction) * weight.track;
  }
}

double ContactSolver::inverseMass(const RestingWeight& weight,
                                  const Eigen::Vector2d& direction) const {
  if (weight.track.isZero(0)) return 1 / weight.mass;
  const double along = weight.track.dot(direction);
  return along * along / weight.mass;
}

void ContactSolver::exchange(const RestingContact& contact, double pushed, double dragged) {
  const Eigen::Vector2d impulse = pushed * contact.normal + dragged * tangentOf(contact);
  push(m_weights[contact.a], 1, impulse);
  if (contact.b >= 0) push(m_weights[contact.b], -1, impulse);
}

void ContactSolver::applyCarried() {
  for (const RestingContact& contact : m_contacts) exchange(contact, contact.push, contact.drag);
}

double ContactSolver::settle(RestingContact& contact, double duration) {
  const double compliance = m_compliance[&contact - m_contacts.data()];
  if (compliance <= 0) return 0;
  RestingWeight& a = m_weights[contact.a];
  const double closing =
      relativeVelocity(contact, m_weights).dot(contact.normal) + contact.gap / duration;
  const double pushed = std::max(0.0, contact.push - closing / compliance);
  const double change = pushed - contact.push;
  contact.push = pushed;
  if (change != 0) exchange(contact, change, 0);
  if (contact.friction <= 0 || !a.track.isZero(0)) return std::abs(change) * compliance;
  const double slip = a.velocity.dot(tangentOf(contact));
  const double most = contact.friction * contact.push;
  const double dragged = std::clamp(contact.drag - slip * a.mass, -most, most);
  const double dragChange = dragged - contact.drag;
  contact.drag = dragged;
  exchange(contact, 0, dragChange);
  return std::max(std::abs(change) * compliance, std::abs(dragChange) / a.mass);
}

bool ContactSolver::solve(double duration, double tolerance, int mostSweeps) {
  struct Impulse {
    double push = 0;
    double drag = 0;
  };
  std::vector<Impulse> direction(m_contacts.size());
  std::vector<Impulse> before(m_contacts.size());
  double lastSquare = 0;
  for (int sweep = 0; sweep < mostSweeps; ++sweep) {
    double largest = 0, square = 0;
    for (std::size_t i = 0; i < m_contacts.size(); ++i) {
      RestingContact& contact = m_contacts[i];
      before[i] = {contact.push, contact.drag};
      largest = std::max(largest, settle(contact, duration));
      const double pushed = contact.push - before[i].push, dragged = contact.drag - before[i].drag;
      square += m_compliance[i] * (pushed * pushed + dragged * dragged);
    }
    if (largest <= tolerance) return true;
    if (sweep + 1 == mostSweeps) break;  // what is further along a direction may not be a push
    const double share = lastSquare > 0 ? square / lastSquare : 2;
    lastSquare = square;
    // A growing residual means that another set of contacts pushes now: start anew.
    const bool restarts = share > 1;
    for (std::size_t i = 0; i < m_contacts.size(); ++i) {
      RestingContact& contact = m_contacts[i];
      const double pushed = contact.push - before[i].push, dragged = contact.drag - before[i].drag;
      if (restarts) {
        direction[i] = {};
        continue;
      }
      const Impulse further{share * direction[i].push, share * direction[i].drag};
      direction[i] = {further.push + pushed, further.drag + dragged};
      contact.push += further.push;
      contact.drag += further.drag;
      exchange(contact, further.push, further.drag);
    }
  }
  return false;
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
  return loss;
}

double slipLoss(std::span<const RestingContact> contacts, std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts)
    loss += std::abs(contact.drag * relativeVelocity(contact, after).dot(tangentOf(contact)));
  return loss;
}

}  // namespace core
