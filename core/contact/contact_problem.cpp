#include "core/contact/contact_problem.h"

#include <algorithm>
#include <numeric>

namespace core {
namespace {

/// A stride that visits each of `count` once, far from the one before.
int strideFor(int count) {
  constexpr double kShare = 0.382;  // the golden section leaves the most even gaps
  int stride = std::max(1, static_cast<int>(kShare * count));
  while (std::gcd(stride, count) > 1) ++stride;
  return stride;
}

DragRow dragRow(const RestingContact& contact, const RestingWeight& weight, int push) {
  DragRow row{};
  row.a = contact.a;
  row.push = push;
  row.tangent = freePart(weight, {-contact.normal.y(), contact.normal.x()});
  row.response = row.tangent / weight.mass;
  row.compliance = row.response.dot(row.tangent);
  row.stiffness = row.compliance > 0 ? 1 / row.compliance : 0;
  row.friction = contact.friction;
  row.drag = contact.drag;
  return row;
}

}  // namespace

Eigen::Vector2d freePart(const RestingWeight& weight, const Eigen::Vector2d& direction) {
  if (weight.track.isZero(0)) return direction;
  return weight.track.dot(direction) * weight.track;
}

PushRow pushRow(const RestingContact& contact, std::span<const RestingWeight> weights,
                double duration) {
  PushRow row{};
  const RestingWeight& a = weights[contact.a];
  row.a = contact.a;
  row.normalA = freePart(a, contact.normal);
  row.responseA = row.normalA / a.mass;
  row.b = static_cast<int>(weights.size());
  row.normalB = row.responseB = Eigen::Vector2d(0, 0);
  if (contact.b >= 0) {
    row.b = contact.b;
    row.normalB = freePart(weights[contact.b], contact.normal);
    row.responseB = row.normalB / weights[contact.b].mass;
  }
  row.gapSpeed = contact.gap / duration;
  row.compliance = row.responseA.dot(row.normalA) + row.responseB.dot(row.normalB);
  row.stiffness = row.compliance > 0 ? 1 / row.compliance : 0;
  row.push = contact.push;
  return row;
}

ContactProblem::ContactProblem(std::span<const RestingWeight> weights,
                               std::span<const RestingContact> contacts, double duration) {
  velocities.reserve(weights.size() + 1);
  for (const RestingWeight& weight : weights) velocities.push_back(weight.velocity);
  velocities.emplace_back(0, 0);
  const int count = static_cast<int>(contacts.size());
  pushes.reserve(count);
  contactOf.reserve(count);
  const int stride = strideFor(count);
  for (int i = 0, k = 0; k < count; ++k, i = (i + stride) % count) {
    const RestingContact& contact = contacts[i];
    pushes.push_back(pushRow(contact, weights, duration));
    contactOf.push_back(i);
    if (contact.friction > 0) drags.push_back(dragRow(contact, weights[contact.a], k));
  }
}

void ContactProblem::store(std::span<RestingWeight> weights,
                           std::span<RestingContact> contacts) const {
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k].velocity = velocities[k];
  for (std::size_t k = 0; k < pushes.size(); ++k) contacts[contactOf[k]].push = pushes[k].push;
  for (const DragRow& row : drags) contacts[contactOf[row.push]].drag = row.drag;
}

}  // namespace core
