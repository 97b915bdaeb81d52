#pragma once

#include <limits>

#include "core/run/stepper.h"

namespace core {

/// How one weight goes on under a method that chooses its own steps.
struct Pace {
  double step = 0;  ///< to try next [s]; 0: not known yet
  // The slope at the end of the latest step, which is the first one of the next step if the
  // weight goes on as it came.
  Mode mode = Mode::kFlight;
  Entries state = Entries::Constant(std::numeric_limits<double>::quiet_NaN());
  Entries slope = Entries::Zero();
};

/// Moves one weight by a method that chooses its own steps, within a tolerance.
///
/// An embedded method's step is kept if its error is at most
///
///     tolerance × (1 + |x|)        in m, m/s, rad, rad/s
///
/// in every entry: absolute for small numbers, relative for large ones. The energy lost to
/// air does not count, so that the ledger never changes where a weight goes. The next step
/// is 0.9 (tolerated error / error)^(1/5) times as long, but neither under a fifth nor over
/// five times. Several steps up to a moment are evened out, so that the last is no splinter.
///
/// The reference's step is as long as the last two terms of its series stay below a hundredth
/// of that bound.
/// Source: Hairer, Nørsett & Wanner, Solving ODEs I, 2nd ed. (1993), §II.4.
class AdaptiveStepper {
 public:
  /// @param stepper    of an adaptive method; counts the evaluations
  /// @param tolerance  [-], > 0
  AdaptiveStepper(Stepper& stepper, double tolerance)
      : m_stepper(&stepper), m_tolerance(tolerance) {}

  /// Fills in a piece whose begin, end, mode and beginState are set: one step of the method,
  /// up to the piece's end or as far as the tolerance reaches, where the piece ends then.
  ///
  /// @return  false if no step that can be told from none keeps the tolerance
  bool fill(const Body& body, Piece& piece, Pace& pace);

 private:
  struct Attempt {
    Entries end, endSlope, bulge;
    double share;  // largest error in units of what is tolerated
  };

  bool fillEmbedded(const Body& body, Piece& piece, Pace& pace);
  bool fillSeries(const Body& body, Piece& piece);
  Entries firstSlope(const Body& body, const Piece& piece, const Pace& pace);
  double firstStep(const Body& body, const Piece& piece);
  Attempt attempted(const Body& body, const Piece& piece, double step);
  double largestShare(const Entries& error, const Entries& state) const;

  Stepper* m_stepper;
  double m_tolerance;
};

}  // namespace core
