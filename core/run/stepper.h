#pragma once

#include <cstdint>
#include <vector>

#include "core/methods/method_list.h"
#include "core/run/equations.h"
#include "core/run/piece.h"
#include "core/run/step_stages.h"

namespace core {

/// Moves one weight by one method through one scene's air and gravity.
class Stepper {
 public:
  /// @param method    a row of the method table
  /// @param gravity   g [m/s²]
  /// @param friction  μ of the floor [-]
  Stepper(const Method& method, double gravity, double friction);

  const Method& method() const { return *m_method; }

  /// d(state)/dt of the weight in that mode.
  Entries slope(const Body& body, Mode mode, const Entries& state);

  /// The same on a piece whose mode and beginState are set. A slide goes on the way it
  /// starts, past its stop as well: the stop is a root of its smooth path.
  Entries slopeOn(const Body& body, const Piece& piece, const Entries& state);

  /// d/ds of the path at the end of a piece whose both ends and beginSlope are known.
  Entries pathEndSlope(const Body& body, const Piece& piece);

  /// Fills in the end of a piece whose begin, end, mode and beginState are set: one step of
  /// the method from its begin to its end. A settled weight keeps its velocity.
  void fill(const Body& body, Piece& piece);

  /// The state after a step of the method from the piece's begin to s, which may lie
  /// anywhere in [begin, end]. Agrees with the path to the method's order, and is what
  /// moments of events are polished with. Where the two do not agree, in a step far too long,
  /// the state on the path: contacts were looked for there.
  Entries partial(const Body& body, const Piece& piece, double s);

  /// The states and slopes of the method's step from the piece's begin to its end, in the
  /// order they were taken; none where the method does not move the weight.
  std::vector<Stage> stages(const Body& body, const Piece& piece);

  /// Nothing moves: held against a wall, or at a stop on the floor.
  static bool isStill(const Piece& piece);

  /// Slope evaluations so far.
  std::int64_t evaluations() const { return m_evaluations; }
  void setEvaluations(std::int64_t count) { m_evaluations = count; }
  /// Counts evaluations made elsewhere.
  void addEvaluations(std::int64_t count) { m_evaluations += count; }

  /// Calls `use` with the method's unit.
  /// @pre the method is in the table
  template <class Use>
  void withUnit(const Use& use) const {
    withMethod(m_index, use);
  }
  /// Calls `use` as withEquations() does.
  template <class Use>
  auto withMotion(const Body& body, const Piece& piece, const Use& use) const {
    return withEquations(body, piece, m_gravity, m_friction, use);
  }

 private:
  static void fillSettled(Piece& piece);
  Entries step(const Body& body, const Piece& piece, double duration);

  const Method* m_method;
  std::size_t m_index;
  double m_gravity;
  double m_friction;  // μ g [m/s²]
  std::int64_t m_evaluations = 0;
};

}  // namespace core
