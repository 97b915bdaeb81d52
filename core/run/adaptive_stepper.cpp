#include "core/run/adaptive_stepper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/methods/method_list.h"
#include "core/methods/taylor_series.h"
#include "core/run/equations.h"

namespace core {
namespace {

// A step is kept short of what the error asks for, and changes by no more than this at once.
constexpr double kSafety = 0.9;
constexpr double kLeastFactor = 0.2;
constexpr double kMostFactor = 5;
// No step is tried that is longer [s]: where nothing bends, steps would grow without end.
constexpr double kLongestStep = 10;
// The reference's last terms stay below this share of what is tolerated: what is left out sums
// up to about a tenth of them.
constexpr double kTermShare = 0.01;
// Nor one that is a smaller share of the moments' size: they could not be told apart.
constexpr double kSmallestShare = 1e-14;

/// `step`, or less so that steps of that length end just at the end of the stretch.
double evened(double step, double stretch) {
  return stretch / std::max(1.0, std::ceil(stretch / step));
}

double factorFor(double share) {
  return std::clamp(kSafety * std::pow(share, -1.0 / 5), kLeastFactor, kMostFactor);
}

/// Hermite's cubic through both ends and u² (1 − u)² times the bulge.
std::shared_ptr<const Polynomial> quartic(const Piece& piece, const Entries& bulge) {
  const double h = piece.end - piece.begin;
  const Entries change = piece.endState - piece.beginState;
  const Entries left = h * piece.beginSlope - change, right = change - h * piece.endSlope;
  Polynomial::Coefficients coefficients(5, 5);
  coefficients.col(0) = piece.beginState.transpose();
  coefficients.col(1) = h * piece.beginSlope.transpose();
  coefficients.col(2) = (right - 2 * left + bulge).transpose();
  coefficients.col(3) = (left - right - 2 * bulge).transpose();
  coefficients.col(4) = bulge.transpose();
  return std::make_shared<const Polynomial>(std::move(coefficients), h);
}

/// Makes the series the piece's path and end.
void followSeries(Piece& piece, const std::array<Series, 5>& series) {
  const double h = piece.end - piece.begin;
  Polynomial::Coefficients coefficients(5, kSeriesDegree + 1);
  double power = 1;
  for (int k = 0; k <= kSeriesDegree; ++k, power *= h)
    for (int i = 0; i < 5; ++i) coefficients(i, k) = series[i][k] * power;
  piece.polynomial = std::make_shared<const Polynomial>(std::move(coefficients), h);
  piece.beginSlope = piece.polynomial->rateAt(0);
  piece.endState = piece.polynomial->at(h);
  piece.endSlope = piece.polynomial->rateAt(h);
}

/// What air took is never given back: where a step's error in that is the larger, it took nothing.
void takeNothingBack(Piece& piece) {
  piece.endState[4] = std::max(piece.endState[4], piece.beginState[4]);
}

}  // namespace

bool AdaptiveStepper::fill(const Body& body, Piece& piece, Pace& pace) {
  if (piece.settled || Stepper::isStill(piece)) {
    m_stepper->fill(body, piece);
    return true;
  }
  if (piece.end <= piece.begin) {  // an event at the very end of the run's step
    piece.beginSlope = piece.endSlope = m_stepper->slope(body, piece.mode, piece.beginState);
    piece.endState = piece.beginState;
    return true;
  }
  if (m_stepper->method().path == PathShape::kPolynomial) return fillSeries(body, piece);
  return fillEmbedded(body, piece, pace);
}

bool AdaptiveStepper::fillEmbedded(const Body& body, Piece& piece, Pace& pace) {
  const double end = piece.end, stretch = end - piece.begin;
  piece.beginSlope = firstSlope(body, piece, pace);
  if (pace.step <= 0) pace.step = firstStep(body, piece);
  double step = evened(std::max(pace.step, kSmallestShare * end), stretch);
  Attempt attempt = attempted(body, piece, step);
  if (!(attempt.share <= 1)) {
    while (!(attempt.share <= 1)) {
      step *= std::isfinite(attempt.share) ? factorFor(attempt.share) : kLeastFactor;
      if (!(step > kSmallestShare * end)) return false;
      attempt = attempted(body, piece, step);
    }
    pace.step = step;
  } else {
    // A step cut short for its moment tells nothing against the longer one.
    const double next = std::min(step * factorFor(attempt.share), kLongestStep);
    pace.step = step < pace.step ? std::max(pace.step, next) : next;
  }
  if (step < stretch) piece.end = piece.begin + step;
  piece.endState = attempt.end;
  takeNothingBack(piece);
  piece.endSlope = attempt.endSlope;
  piece.polynomial = quartic(piece, attempt.bulge);
  pace.mode = piece.mode;
  pace.state = piece.endState;
  pace.slope = piece.endSlope;
  return true;
}

Entries AdaptiveStepper::firstSlope(const Body& body, const Piece& piece, const Pace& pace) {
  if (pace.mode == piece.mode && (pace.state == piece.beginState).all()) return pace.slope;
  return m_stepper->slope(body, piece.mode, piece.beginState);
}

/// Such that the error of a step of order 5 is about a hundredth of the tolerance, judged by
/// how the slope changes over a short Euler step.
double AdaptiveStepper::firstStep(const Body& body, const Piece& piece) {
  const Entries& state = piece.beginState;
  const double size = largestShare(state, state);
  const double speed = largestShare(piece.beginSlope, state);
  const double probe = size > 0 && speed > 0 ? 0.01 * size / speed : 1e-6;
  const Entries ahead = m_stepper->slopeOn(body, piece, state + probe * piece.beginSlope);
  const double bend = largestShare(ahead - piece.beginSlope, state) / probe;
  const double fastest = std::max(speed, bend);
  if (!(fastest > 0)) return kLongestStep;
  return std::min({100 * probe, std::pow(0.01 / fastest, 1.0 / 5), kLongestStep});
}

AdaptiveStepper::Attempt AdaptiveStepper::attempted(const Body& body, const Piece& piece,
                                                    double step) {
  Attempt attempt;
  m_stepper->withUnit([&](auto unit) {
    if constexpr (unit.kRow.isAdaptive) {
      m_stepper->withMotion(body, piece, [&](const auto& motion, auto form) {
        const auto stages =
            unit.step(motion, form.from(piece.beginState), form.from(piece.beginSlope), step);
        const double across = piece.beginState[1];
        attempt.end = form.entries(stages.end, across);
        attempt.endSlope = form.entries(stages.slopes.back(), 0);
        attempt.bulge = form.entries(unit.bulge(stages, step), 0);
        const Entries error = form.entries(unit.error(stages, step), 0);
        attempt.share = largestShare(error, piece.beginState.abs().max(attempt.end.abs()));
      });
    }
  });
  m_stepper->addEvaluations(m_stepper->method().slopesPerStep - 1);
  return attempt;
}

/// The largest of four entries in units of what is tolerated; the energy does not count.
double AdaptiveStepper::largestShare(const Entries& entries, const Entries& state) const {
  const auto shares = entries.abs() / (m_tolerance * (1 + state.abs()));
  return shares.head<4>().maxCoeff<Eigen::PropagateNaN>();
}

bool AdaptiveStepper::fillSeries(const Body& body, Piece& piece) {
  std::array<Series, 5> series{};
  m_stepper->withMotion(body, piece, [&](const auto& motion, auto form) {
    series = form.series(motion.series(form.from(piece.beginState)), piece.beginState[1]);
  });
  m_stepper->addEvaluations(1);
  std::array<double, 4> errors{};
  for (int i = 0; i < 4; ++i)
    errors[i] = kTermShare * m_tolerance * (1 + std::abs(piece.beginState[i]));
  const double own = TaylorSeries::reach(series, errors);
  const double reach = own > kLongestStep ? kLongestStep : own;
  if (!(reach > kSmallestShare * piece.end)) return false;
  const double stretch = piece.end - piece.begin;
  const double step = evened(reach, stretch);
  if (step < stretch) piece.end = piece.begin + step;
  followSeries(piece, series);
  takeNothingBack(piece);
  return true;
}

}  // namespace core
