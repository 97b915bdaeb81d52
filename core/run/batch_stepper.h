#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/methods/method.h"
#include "core/motion/lanes.h"
#include "core/run/piece.h"

namespace core {

/// Fills pieces as Stepper does, to the same bits, for weights side by side: several times
/// faster where there are many.
class BatchStepper {
 public:
  /// @param method   a row of the method table; one that is adaptive must not add() anything
  /// @param gravity  g [m/s²]
  BatchStepper(const Method& method, double gravity);

  /// Whether it can step this piece: a weight in flight or on a taut rope.
  static bool takes(const Piece& piece);

  /// Fills in the end of a piece whose begin, end, mode and beginState are set, at once or
  /// when others have joined it, at the latest in finish(). All pieces since the last
  /// finish() last equally long.
  void add(const Body& body, Piece& piece);

  /// Fills in whatever still waits.
  /// @return  slope evaluations since the last finish()
  std::int64_t finish();

 private:
  template <int kEntries>
  struct Block {
    int count = 0;
    std::array<Piece*, Lanes::kCount> pieces{};
    double duration = 0;  // [s]
    Lanes mass = 1, length = 1, drag = 0;
    StateArray<kEntries, Lanes> begin, end, beginSlope, endSlope;

    Block() { begin.fill(0); }
    /// @return  whether it is full
    bool add(const Body& body, Piece& piece, const StateArray<kEntries>& state);
  };

  static void stepFlights(std::size_t method, double gravity, Block<5>& block);
  static void stepSwings(std::size_t method, double gravity, Block<3>& block);
  void fillFlights();
  void fillSwings();

  const Method* m_method;
  std::size_t m_index;
  double m_gravity;
  std::int64_t m_evaluations = 0;
  Block<5> m_flights;
  Block<3> m_swings;
};

}  // namespace core
