#pragma once

#include <set>
#include <utility>
#include <vector>

#include "core/contact/resting.h"
#include "core/run/engine.h"

namespace core {

/// What else than another weight a contact of a group may be with.
enum Surface { kFloor = -1, kCeiling = -2, kWest = -3, kEast = -4, kRopeEnd = -5 };

/// Gaps up to this count as touching within a group [m].
constexpr double kTouchingGap = 1e-9;

/// Weights that lean on each other are kept this far apart [m]: what a bounded number of sweeps
/// leaves unsolved in a stretch is less, so that they do not overlap.
constexpr double kSkin = 2e-6;

/// Some settled weights with their contacts, in the solver's terms.
class Engine::Group {
 public:
  /// @param s         moment in the step [s]
  /// @param duration  of the stretch the contacts are looked for in [s], > 0
  Group(Engine& engine, double s, double duration)
      : m_engine(engine), m_s(s), m_duration(duration) {}
  ~Group();
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void add(int index);
  int size() const { return static_cast<int>(members.size()); }
  int localOf(int index) const { return m_engine.m_localOf[index]; }
  bool isExpanded(int local) const { return m_expanded[local]; }

  /// Finds all contacts of a member within its reach; settled weights it finds become members.
  void expand(int local);

  /// Solves; when that made members faster than their contacts were looked for, looks again.
  void solve(const ContactGoal& goal);

  /// Notes the members that some contact pushes now.
  void markPushed();

  std::vector<int> members;              // indices of weights
  std::vector<RestingWeight> weights;    // in the order of members
  std::vector<Eigen::Vector2d> places;   // likewise [m]
  std::vector<RestingContact> contacts;  // refer to places in `members`
  std::vector<int> keys;                 // of contacts: other weight, or Surface
  /// Velocities when they became members; from solveImpacts() on, those after impacts and
  /// before forces [m/s].
  std::vector<Eigen::Vector2d> unkicked;
  std::vector<char> hitOrHeld;  // of members: some contact pushes

 private:
  double reachAt(double speed) const;
  void lookAt(int local, int other);
  void addSurfacesOf(int local);
  void addContact(const RestingContact& contact, int key);

  Engine& m_engine;
  double m_s;
  double m_duration;
  std::vector<double> m_reach;  // of members: how far their contacts were looked for [m]
  std::vector<bool> m_expanded;
  std::set<std::pair<int, int>> m_pairs;  // weights, or weight and Surface, with a contact
};

}  // namespace core
