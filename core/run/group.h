#pragma once

#include <array>
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
/// leaves unsolved in a stretch is less, so that they do not overlap. In large heaps it leaves
/// more, and they are kept further apart: Engine::skin().
constexpr double kSkin = 4e-6;

/// What narrow gaps that are widened, and bends of circles, may cost at once, as a share of the
/// kinetic energy that was there.
constexpr double kBought = 1e-2;

/// What pushes a weight of a group.
enum class Support : char { kNone, kFloor, kOthers };

/// Some settled weights with their contacts, in the solver's terms.
class Engine::Group {
 public:
  /// @param s         moment in the step [s]
  /// @param duration  of the stretch the contacts are looked for in [s], > 0
  /// @param widens    gaps narrower than they should be are made wider in the stretch
  Group(Engine& engine, double s, double duration, bool widens)
      : m_engine(engine), m_s(s), m_duration(duration), m_widens(widens) {}
  ~Group();
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void add(int index);
  /// Adds two weights that hit each other, and their contact. One that is not settled has no
  /// other contacts in the group.
  /// @param normal       from a to b
  /// @param restitution  speed after / speed before along the normal
  void addHit(int a, int b, const Eigen::Vector2d& normal, double restitution);
  /// Takes all pushes back; the two that hit each other shall part no more than by gaps of others.
  void undoHit();
  /// From now on circles are taken as straight lines, but by stopUnsolved().
  void straighten() { m_bends = false; }
  int size() const { return static_cast<int>(members.size()); }
  double duration() const { return m_duration; }
  int localOf(int index) const { return m_engine.m_localOf[index]; }
  bool isExpanded(int local) const { return m_expanded[local]; }

  /// Calls `use(contact)` for each contact of a member, the one found last first.
  template <class Use>
  void forEachContact(int local, Use&& use) const {
    for (int i = m_firstContact[local]; i >= 0;) {
      const int next = m_nextContact[i][contacts[i].a == local ? 0 : 1];
      use(i);
      i = next;
    }
  }

  /// Finds all contacts of a member within its reach; settled weights it finds become members.
  void expand(int local);

  /// Solves; when that made members faster than their contacts were looked for, looks again.
  void solve(const ContactGoal& goal);

  /// Narrows the gaps to weights on ropes by what their circles bend towards each other within
  /// the stretch, at the speeds they have now.
  /// @return  whether that made a difference
  bool bend();

  /// Whether a member is, or may soon be, further than its contacts were looked for.
  bool outruns(int local) const { return reachAt(weights[local].velocity.norm()) > m_reach[local]; }
  /// Looks for its contacts further away, when it has become faster.
  void lookFurther(int local);

  /// Stops members that their velocities would lead deep into each other within the stretch, and
  /// turns away those that would then run into them: what no number of sweeps solves, such as
  /// 10⁹ kg that drive 10⁻⁶ kg into a corner at 10⁵ m/s, shall not end in an overlap.
  /// @return  the kinetic energy that takes [J]
  double stopUnsolved();

  /// Of the members when they came [J].
  double kineticEnergyBefore() const;
  /// What pushes and drags took from the members since they came [J].
  double loss() const;

  /// Notes what pushes the members: the floor counts where nothing else does and no rope ties.
  void findSupport();

  std::vector<int> members;               // indices of weights
  std::vector<RestingWeight> weights;     // in the order of members
  std::vector<Eigen::Vector2d> places;    // likewise [m]
  std::vector<RestingContact> contacts;   // refer to places in `members`
  std::vector<int> keys;                  // of contacts: other weight, or Surface
  std::vector<Eigen::Vector2d> unkicked;  // velocities when they became members [m/s]
  std::vector<Eigen::Vector2d> told;      // velocities their neighbours know of [m/s]
  std::vector<Support> support;           // of members

 private:
  double reachAt(double speed) const;
  bool isLetGo(int local) const;
  bool isPushed(int local, double push) const;
  double excessAt(std::size_t contact) const;
  double kineticEnergy() const;
  void lookAt(int local, int other);
  void addSurfacesOf(int local);
  double widened(double gap) const;
  Eigen::Vector2d bendOf(int local) const;
  double bendAt(const RestingContact& contact) const;
  double turnOf(int local) const;
  bool turnsFar(int local) const;
  Piece wayOf(int local) const;
  bool runsInto(const RestingContact& contact) const;
  void addContact(const RestingContact& contact, int key);
  void link(const RestingContact& contact, int key, double realGap);
  void meetOthers(int local);
  bool hasContact(int local, int key) const;

  Engine& m_engine;
  double m_s;
  double m_duration;
  bool m_widens;
  int m_hit = -1;  // the contact whose gap says how fast the two shall part; −1: none
  bool m_hasRopes = false;
  bool m_bends = true;
  std::vector<double> m_realGaps;      // of contacts, without a skin [m]
  std::vector<double> m_straightGaps;  // likewise to be kept, as none of the two bends [m]
  std::vector<int> m_firstContact;     // of members; −1: none
  std::vector<std::array<int, 2>> m_nextContact;  // of contacts: the next one of a and of b
  std::vector<double> m_reach;  // of members: how far their contacts were looked for [m]
  std::vector<bool> m_expanded;
};

}  // namespace core
