#include "core/contact/contact_sweeps.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

// Where a heap is jammed so that gaps cannot open as they should, every sweep finds the same and
// only the pushes grow. After so many sweeps whose residuals differ by less than this share that
// is so, if what is left is slow anyway [m/s].
constexpr int kStuckSweeps = 20;
constexpr double kStuckShare = 1e-5;
constexpr double kStuckSpeed = 3e-5;
// A bound on the sweeps is for large heaps: so many contacts are always set right [-]. It takes
// that where a few light weights stand between heavy ones.
constexpr int kLeastWork = 30'000;
// What is left at that bound may be so fast [m/s], and so many tolerances; else the bound is
// raised, unless it is so fast that there is little hope.
constexpr double kLeftSpeed = 1e-4;
constexpr double kLeftTolerances = 10;
constexpr int kRaised = 4;
constexpr double kHopelessSpeed = 2e-3;  // [m/s]
// Slips need not be right to more than this many tolerances: they make no overlap, and where
// friction makes a heap stiffer than it need be, drags are not settled by anything else.
constexpr double kSlipTolerances = 100;

/// What one sweep over all contacts did.
struct Sweep {
  double largest = 0;  // change of an approach, or share of that of a slip [m/s]
  double square = 0;   // of all changes, in the metric of the masses [J]
};

void settle(PushRow& row, ContactProblem& problem) {
  settle(row, problem.velocities[row.a], problem.velocities[row.b]);
}

void sweepPushes(ContactProblem& problem, Sweep& sweep) {
  for (PushRow& row : problem.pushes) {
    settle(row, problem);
    const double speed = std::abs(row.change) * row.compliance;
    sweep.largest = std::max(sweep.largest, speed);
    sweep.square += speed * std::abs(row.change);
  }
}

/// Surfaces have the last word: whatever is left unsolved, nothing leaves the room.
void keepAllInside(ContactProblem& problem) {
  const int surface = static_cast<int>(problem.velocities.size()) - 1;
  for (PushRow& row : problem.pushes)
    if (row.b == surface) keepInside(row, problem.velocities[row.a]);
}

void sweepDrags(ContactProblem& problem, Sweep& sweep) {
  for (DragRow& row : problem.drags) {
    Eigen::Vector2d& a = problem.velocities[row.a];
    const double most = row.friction * problem.pushes[row.push].push;
    const double dragged = std::clamp(row.drag - row.tangent.dot(a) * row.stiffness, -most, most);
    row.change = dragged - row.drag;
    row.drag = dragged;
    a += row.change * row.response;
    const double speed = std::abs(row.change) * row.compliance;
    sweep.largest = std::max(sweep.largest, speed / kSlipTolerances);
    sweep.square += speed * std::abs(row.change);
  }
}

/// Conjugate directions over the sweeps, as what they do to velocities; the rows hold the
/// impulses.
class Directions {
 public:
  explicit Directions(ContactProblem& problem)
      : m_problem(problem),
        m_direction(problem.velocities.size(), Eigen::Vector2d(0, 0)),
        m_before(problem.velocities) {}

  void reset() {
    for (PushRow& row : m_problem.pushes) row.direction = 0;
    for (DragRow& row : m_problem.drags) row.direction = 0;
    std::ranges::fill(m_direction, Eigen::Vector2d(0, 0));
    m_before = m_problem.velocities;
  }

  /// Goes `share` of the latest direction further; the sweep and that are the next direction.
  void extrapolate(double share) {
    for (PushRow& row : m_problem.pushes) {
      const double further = share * row.direction;
      row.direction = further + row.change;
      row.push += further;
    }
    for (DragRow& row : m_problem.drags) {
      const double further = share * row.direction;
      row.direction = further + row.change;
      row.drag += further;
    }
    for (std::size_t k = 0; k < m_direction.size(); ++k) {
      const Eigen::Vector2d further = share * m_direction[k];
      m_direction[k] = further + m_problem.velocities[k] - m_before[k];
      m_problem.velocities[k] += further;
      m_before[k] = m_problem.velocities[k];
    }
  }

 private:
  ContactProblem& m_problem;
  std::vector<Eigen::Vector2d> m_direction;  // of velocities
  std::vector<Eigen::Vector2d> m_before;     // velocities before the sweep
};

}  // namespace

bool solveBySweeps(ContactProblem& problem, const ContactGoal& goal) {
  Directions directions(problem);
  const int contacts = std::max(1, static_cast<int>(problem.pushes.size()));
  const int mostSweeps = std::max(goal.mostSweeps, kLeastWork / contacts);
  const double mostLeft = std::max(kLeftSpeed, kLeftTolerances * goal.tolerance);
  double lastSquare = 0;
  int alike = 0;  // sweeps, one after the other
  for (int count = 1;; ++count) {
    Sweep sweep;
    sweepPushes(problem, sweep);
    sweepDrags(problem, sweep);
    const double share = lastSquare > 0 ? sweep.square / lastSquare : 2;
    lastSquare = sweep.square;
    alike = std::abs(share - 1) < kStuckShare ? alike + 1 : 0;
    const bool isStuck = alike >= kStuckSweeps && sweep.largest <= kStuckSpeed;
    const bool solved = sweep.largest <= goal.tolerance;
    const bool isWorthMore = sweep.largest > mostLeft && sweep.largest < kHopelessSpeed;
    const int bound = isWorthMore ? kRaised * mostSweeps : mostSweeps;
    if (solved || isStuck || count >= bound) {  // further on may be no push
      keepAllInside(problem);
      return solved;
    }
    // A growing residual means that another set of contacts pushes now: start anew.
    if (share > 1) {
      directions.reset();
    } else {
      directions.extrapolate(share);
    }
  }
}

}  // namespace core
