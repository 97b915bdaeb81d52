#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/aim/landing_finder.h"
#include "core/aim/target.h"

namespace core {

/// Which landings are asked for.
struct CutSweepQuestion {
  int weight = 0;           ///< index
  double from = 0;          ///< first cut time [s], ≥ 0
  double until = 10;        ///< last cut time [s], > from
  double longestWait = 10;  ///< for a landing, from the cut on [s], > 0
};

/// Cut times in a row that all make the weight land on the target, after the same history.
struct Hit {
  double from = 0;   ///< [s]
  double until = 0;  ///< [s], > from
  /// Cut times that hit the center of the target [s]; none where it is only passed by.
  std::vector<double> centers;
  double best = 0;       ///< the cut time that comes nearest to the center [s]
  double offCenter = 0;  ///< by how much its landing misses it [m], ≥ 0
  double landsAt = 0;    ///< time of that landing [s]
  FirstHit firstHit = FirstHit::kNothing;
};

/// Landing place of a weight against the time at which all ropes are cut.
///
/// The range is sampled evenly, closer than the swing of the weight's rope can change, and then
/// between samples wherever the place moves far, until it is smooth to the eye. Where what the
/// weight hits on its way changes, the place may jump: such a moment is enclosed between two cut
/// times less than kSharpness apart. Where the curve turns the turn itself is sampled. A feature
/// that begins and ends between two samples with the same history is missed.
class CutSweep {
 public:
  /// How exactly moments are known, apart from the error of the method [s].
  static constexpr double kSharpness = 1e-8;

  /// @pre as for LandingFinder; 0 ≤ from < until
  CutSweep(const Scene& scene, const Solver& solver, const CutSweepQuestion& question);

  const CutSweepQuestion& question() const { return m_question; }
  const Solver& solver() const { return m_solver; }

  /// Finds the curve. To be called first, and once.
  /// @param progress  may be empty
  /// @return          false if the progress stopped it: the sweep is of no use then
  bool compute(const Progress& progress = {});

  /// What was computed, in order of cut times. Ends early where the hanging run could not go on.
  std::vector<Landing> landings() const;
  /// False where places jump too often to tell all jumps from each other.
  bool isResolved() const { return m_isResolved; }

  /// The moments that hit, in order; each end and center is a root, narrowed down to 10⁻¹⁰ s, or
  /// a jump of the curve, to kSharpness. Spans shorter than 2 kSharpness are left out.
  /// @return  nothing if the progress stopped it
  /// @pre compute() returned true
  std::optional<std::vector<Hit>> hitsOn(const Target& target, const Progress& progress = {});

 private:
  struct Gap {
    double from;
    double to;
  };

  double spacing() const;
  bool sample(double cutTime, WorkMeter& meter);
  bool sampleEvenly(WorkMeter& meter);
  bool isTooWide(const Landing& a, const Landing& b) const;
  bool refine(std::vector<Gap> gaps, WorkMeter& meter);
  bool refineAll(WorkMeter& meter);
  bool sampleTurns(WorkMeter& meter);
  bool sampleTurn(const Landing& a, const Landing& b, const Landing& c, WorkMeter& meter);

  Scene m_scene;
  Solver m_solver;
  CutSweepQuestion m_question;
  LandingFinder m_finder;
  std::map<double, Landing> m_landings;  // by cut time
  std::size_t m_most = 0;                // that may be sampled
  bool m_isResolved = true;
};

}  // namespace core
