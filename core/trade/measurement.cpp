#include "core/trade/measurement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

#include "core/system/cpu_clock.h"
#include "core/trade/timing.h"
#include "core/trade/trusted_course.h"

namespace core {
namespace {

// Of the work: the two reference solutions, and of each point the run that is looked at.
constexpr double kShareOfReference = 0.1;
constexpr double kShareOfLooking = 0.5;
constexpr int kWeightStepsUnasked = 20'000;  // between two questions whether to go on
constexpr double kGuessedStep = 1e-3;        // [s] of an adaptive method

/// About how much work a point is, in steps; only the proportions matter.
double workOf(const Solver& solver) {
  return 1 / (findMethod(solver.method)->isAdaptive ? kGuessedStep : solver.step);
}

/// One run, looked at while it goes on.
class ObservedRun {
 public:
  ObservedRun(const std::shared_ptr<const Scene>& scene, const Solver& solver,
              const TrustedCourse& trusted)
      : m_trusted(trusted), m_run(scene, solver), m_positions(scene->weights.size()) {
    m_point.solver = solver;
    look();
  }

  bool goesOn() const {
    return m_run.time() < m_trusted.until() && m_run.status() == RunStatus::kRunning;
  }

  /// Takes some steps.
  void goOn() {
    const int steps = std::max(1, kWeightStepsUnasked / (1 + m_run.weightCount()));
    for (int i = 0; i < steps && goesOn(); ++i) {
      if (m_run.advance() == RunStatus::kRunning) look();
    }
  }

  /// 0 to 1.
  double share() const { return goesOn() ? m_run.time() / m_trusted.until() : 1; }

  MeasuredPoint point() const {
    MeasuredPoint point = m_point;
    point.steps = m_run.method().isAdaptive ? ownSteps() : m_run.stepCount();
    point.evaluations = m_run.slopeEvaluations();
    point.status = m_run.status();
    point.reached = m_run.time();
    return point;
  }

 private:
  std::int64_t ownSteps() const {
    return m_run.slopeEvaluations() / m_run.method().slopesPerStep /
           std::max(1, m_run.weightCount());
  }

  void look() {
    for (; m_next < m_trusted.course.count() && m_trusted.times.at(m_next) <= m_run.time();
         ++m_next) {
      compare(m_trusted.times.at(m_next));
      // Of an adaptive method the run shows its common steps only, which are long.
      if (m_run.method().isAdaptive) noteDrift(m_trusted.times.at(m_next));
    }
    noteDrift(std::min(m_run.time(), m_trusted.until()));
  }

  void noteDrift(double time) {
    const double drift = std::abs(m_run.energiesAt(time).numericalDrift);
    m_point.maxEnergyDrift = std::max(m_point.maxEnergyDrift, drift);
  }

  void compare(double time) {
    for (int i = 0; i < m_run.weightCount(); ++i) {
      m_positions[static_cast<std::size_t>(i)] = m_run.weightAt(i, time).position;
    }
    m_point.maxPositionError = std::max(m_point.maxPositionError,
                                        largestDistance(m_positions, m_trusted.course.at(m_next)));
  }

  const TrustedCourse& m_trusted;
  Run m_run;
  std::vector<Eigen::Vector2d> m_positions;
  MeasuredPoint m_point;
  int m_next = 0;
};

/// All points of a measurement, by several threads.
class Workshop {
 public:
  Workshop(const std::shared_ptr<const Scene>& scene, const std::vector<Solver>& solvers,
           const TrustedCourse& trusted, const Progress& progress)
      : m_scene(scene),
        m_solvers(solvers),
        m_trusted(trusted),
        m_points(solvers.size()),
        m_order(solvers.size()),
        m_meter(totalWork(), progress) {
    // The longest first, or one thread would wait for the other in the end.
    std::iota(m_order.begin(), m_order.end(), 0);
    std::ranges::stable_sort(m_order, std::greater<>(),
                             [this](std::size_t i) { return workOf(m_solvers[i]); });
  }

  /// @return  false if it was stopped
  bool measureAll() {
    {
      const std::jthread helper([this] { measureRemaining(); });
      measureRemaining();
    }
    return m_meter.add(0);
  }

  const std::vector<MeasuredPoint>& points() const { return m_points; }

 private:
  double totalWork() const {
    double total = 0;
    for (const Solver& solver : m_solvers) total += workOf(solver);
    return total;
  }

  void measureRemaining() {
    for (std::size_t next = m_next++; next < m_order.size(); next = m_next++) {
      const std::size_t i = m_order[next];
      if (!measurePoint(m_solvers[i], m_points[i])) return;
    }
  }

  bool measurePoint(const Solver& solver, MeasuredPoint& point) {
    ObservedRun observed(m_scene, solver, m_trusted);
    const double start = threadCpuTime();
    double done = 0;
    while (observed.goesOn()) {
      observed.goOn();
      const double share = kShareOfLooking * observed.share();
      if (!m_meter.add((share - done) * workOf(solver))) return false;
      done = share;
    }
    point = observed.point();
    point.nanosecondsPerSimulatedSecond = nanosecondsPerSimulatedSecond(
        m_scene, solver, m_trusted.until(), threadCpuTime() - start, m_meter);
    return m_meter.add((1 - done) * workOf(solver));
  }

  const std::shared_ptr<const Scene>& m_scene;
  const std::vector<Solver>& m_solvers;
  const TrustedCourse& m_trusted;
  std::vector<MeasuredPoint> m_points;
  std::vector<std::size_t> m_order;
  WorkMeter m_meter;
  std::atomic<std::size_t> m_next = 0;
};

std::vector<MethodCurve> curvesOf(const std::vector<MeasuredPoint>& points) {
  std::vector<MethodCurve> curves;
  for (const MeasuredPoint& point : points) {
    const Method* method = findMethod(point.solver.method);
    const auto found = std::ranges::find(curves, method, &MethodCurve::method);
    (found == curves.end() ? curves.emplace_back(MethodCurve{method, {}}) : *found)
        .points.push_back(point);
  }
  return curves;
}

}  // namespace

std::optional<Measurement> measure(const std::shared_ptr<const Scene>& scene,
                                   const std::vector<Solver>& solvers, double until,
                                   const Progress& progress) {
  const auto part = [&progress](double from, double share) -> Progress {
    if (!progress) return {};
    return [&progress, from, share](double done) { return progress(from + share * done); };
  };
  const std::optional<TrustedCourse> trusted =
      trustedCourse(scene, until, part(0, kShareOfReference));
  if (!trusted) return std::nullopt;
  const Progress rest = part(kShareOfReference, 1 - kShareOfReference);
  Workshop workshop(scene, solvers, *trusted, rest);
  if (!workshop.measureAll()) return std::nullopt;
  return Measurement{until, trusted->until(), trusted->uncertainty,
                     static_cast<int>(scene->weights.size()), curvesOf(workshop.points())};
}

}  // namespace core
