#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/contact/contact_problem.h"
#include "core/run/group.h"

namespace core {

/// A hit on its way through a group: contacts are set right in the order in which the change
/// of a velocity reaches them, and only those it reaches. A weight's neighbours are looked for
/// when it moves differently.
///
/// That is Gauss–Seidel on a growing problem, which takes long where the hit is strong and the
/// group is deep; there sweeps over all contacts found so far take over.
class Engine::HitWave {
 public:
  /// @param group     holds the two that hit, with their contact
  /// @param goal      its tolerance is also the change of velocity that need not go on
  /// @param duration  of the group's stretch [s], > 0
  HitWave(Group& group, const ContactGoal& goal, double duration);

  /// Gives the group's weights the velocities, and its contacts the pushes, that the hit leads to.
  void run();

 private:
  void lookAround(int local);
  void addRows();
  bool runThroughQueue();
  bool followBends();
  void takeGaps();
  void sweep();
  void settle(int index);
  void brake(int index);
  void tell(int local);
  bool hasChanged(int local) const;
  void enqueue(int row);

  Group& m_group;
  ContactGoal m_goal;
  double m_duration;
  std::vector<PushRow> m_rows;  // of the group's contacts; surfaces: b is a
  std::vector<int> m_queue;     // of rows to be set right, from m_next on
  std::size_t m_next = 0;
  std::vector<char> m_waits;  // of rows: in the queue
};

}  // namespace core
