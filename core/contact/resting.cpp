#include "core/contact/resting.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

Eigen::Vector2d tangentOf(const RestingContact& contact) {
  return {-contact.normal.y(), contact.normal.x()};
}

/// What an impulse of 1 N s along a unit vector does to the weight's velocity [m/s].
Eigen::Vector2d changeOf(const RestingWeight& weight, const Eigen::Vector2d& direction) {
  if (weight.track.isZero(0)) return direction / weight.mass;
  return weight.track.dot(direction) / weight.mass * weight.track;
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
  m_responses.reserve(contacts.size());
  for (const RestingContact& contact : contacts) {
    Response response;
    response.normalA = changeOf(weights[contact.a], contact.normal);
    response.tangentA = changeOf(weights[contact.a], tangentOf(contact));
    response.normalB.setZero();
    if (contact.b >= 0) response.normalB = -changeOf(weights[contact.b], contact.normal);
    response.compliance = (response.normalA - response.normalB).dot(contact.normal);
    m_responses.push_back(response);
  }
}

void ContactSolver::exchange(std::size_t index, double pushed, double dragged) {
  const RestingContact& contact = m_contacts[index];
  const Response& response = m_responses[index];
  m_weights[contact.a].velocity += pushed * response.normalA + dragged * response.tangentA;
  if (contact.b >= 0) m_weights[contact.b].velocity += pushed * response.normalB;
}

void ContactSolver::applyCarried() {
  for (std::size_t i = 0; i < m_contacts.size(); ++i)
    exchange(i, m_contacts[i].push, m_contacts[i].drag);
}

double ContactSolver::settle(std::size_t index, double duration) {
  RestingContact& contact = m_contacts[index];
  const Response& response = m_responses[index];
  if (response.compliance <= 0) return 0;
  RestingWeight& a = m_weights[contact.a];
  const double closing =
      relativeVelocity(contact, m_weights).dot(contact.normal) + contact.gap / duration;
  const double pushed = std::max(0.0, contact.push - closing / response.compliance);
  const double change = pushed - contact.push;
  contact.push = pushed;
  if (change != 0) exchange(index, change, 0);
  if (contact.friction <= 0) return std::abs(change) * response.compliance;
  const double slip = a.velocity.dot(tangentOf(contact));
  const double most = contact.friction * contact.push;
  const double dragged = std::clamp(contact.drag - slip * a.mass, -most, most);
  const double dragChange = dragged - contact.drag;
  contact.drag = dragged;
  if (dragChange != 0) exchange(index, 0, dragChange);
  return std::max(std::abs(change) * response.compliance, std::abs(dragChange) / a.mass);
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
      largest = std::max(largest, settle(i, duration));
      const double pushed = contact.push - before[i].push, dragged = contact.drag - before[i].drag;
      square += m_responses[i].compliance * (pushed * pushed + dragged * dragged);
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
      exchange(i, further.push, further.drag);
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
