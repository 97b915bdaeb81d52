#include "core/contact/resting.h"

#include <algorithm>
#include <cmath>
#include <deque>

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
    : m_weights(weights), m_contacts(contacts), m_firstOf(weights.size() + 1, 0) {
  for (const RestingContact& contact : contacts) {
    ++m_firstOf[contact.a + 1];
    if (contact.b >= 0) ++m_firstOf[contact.b + 1];
  }
  for (std::size_t i = 1; i < m_firstOf.size(); ++i) m_firstOf[i] += m_firstOf[i - 1];
  m_contactsOf.resize(m_firstOf.back());
  std::vector<int> next(m_firstOf.begin(), m_firstOf.end() - 1);
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    m_contactsOf[next[contacts[i].a]++] = i;
    if (contacts[i].b >= 0) m_contactsOf[next[contacts[i].b]++] = i;
  }
}

std::span<const int> ContactSolver::contactsOf(int weight) const {
  return std::span(m_contactsOf)
      .subspan(m_firstOf[weight], m_firstOf[weight + 1] - m_firstOf[weight]);
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

void ContactSolver::applyCarried() {
  for (const RestingContact& contact : m_contacts) {
    if (contact.push == 0) continue;
    const Eigen::Vector2d impulse =
        contact.push * contact.normal + contact.drag * tangentOf(contact);
    push(m_weights[contact.a], 1, impulse);
    if (contact.b >= 0) push(m_weights[contact.b], -1, impulse);
  }
}

bool ContactSolver::settle(RestingContact& contact, double duration, double tolerance) {
  RestingWeight& a = m_weights[contact.a];
  RestingWeight* b = contact.b < 0 ? nullptr : &m_weights[contact.b];
  const auto exchange = [&](double impulse, const Eigen::Vector2d& direction) {
    push(a, impulse, direction);
    if (b) push(*b, -impulse, direction);
  };
  const double compliance =
      inverseMass(a, contact.normal) + (b ? inverseMass(*b, contact.normal) : 0);
  if (compliance <= 0) return false;
  const double closing =
      relativeVelocity(contact, m_weights).dot(contact.normal) + contact.gap / duration;
  const double pushed = std::max(0.0, contact.push - closing / compliance);
  const double change = pushed - contact.push;
  bool moved = std::abs(change) * compliance > tolerance;
  if (change != 0) exchange(change, contact.normal);
  contact.push = pushed;
  if (contact.friction <= 0 || !a.track.isZero(0)) return moved;
  const Eigen::Vector2d tangent = tangentOf(contact);
  const double slip = a.velocity.dot(tangent);
  const double most = contact.friction * contact.push;
  const double dragged = std::clamp(contact.drag - slip * a.mass, -most, most);
  moved = moved || std::abs(dragged - contact.drag) > tolerance * a.mass;
  exchange(dragged - contact.drag, tangent);
  contact.drag = dragged;
  return moved;
}

bool ContactSolver::solve(std::span<const int> contacts, double duration, double tolerance,
                          long mostVisits) {
  std::deque<int> queue(contacts.begin(), contacts.end());
  std::vector<char> waiting(m_contacts.size(), 0);
  for (const int i : contacts) waiting[i] = 1;
  const auto wake = [&](int weight, int except) {
    for (const int i : contactsOf(weight)) {
      if (waiting[i] || i == except) continue;
      waiting[i] = 1;
      queue.push_back(i);
    }
  };
  for (long visits = 0; !queue.empty(); ++visits) {
    if (visits == mostVisits) return false;
    const int i = queue.front();
    queue.pop_front();
    waiting[i] = 0;
    if (!settle(m_contacts[i], duration, tolerance)) continue;
    wake(m_contacts[i].a, i);
    if (m_contacts[i].b >= 0) wake(m_contacts[i].b, i);
  }
  return true;
}

double inelasticLoss(std::span<const RestingContact> contacts,
                     std::span<const RestingWeight> before, std::span<const RestingWeight> after) {
  double loss = 0;
  for (const RestingContact& contact : contacts) {
    const Eigen::Vector2d mean =
        relativeVelocity(contact, before) + relativeVelocity(contact, after);
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
