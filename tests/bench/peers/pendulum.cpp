#include "tests/bench/peers/pendulum.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <numbers>

#include "core/methods/method_list.h"
#include "core/motion/drag.h"
#include "core/motion/swing.h"
#include "core/run/adaptive_stepper.h"
#include "core/run/run.h"
#include "core/trade/reference.h"

namespace bench {
namespace {

void solveByRungeKutta(const Pendulum& pendulum, double rate, const Watch* watch) {
  const core::Swing<> swing(pendulum.pull * pendulum.length, pendulum.length, 1,
                            pendulum.drag / pendulum.length);
  core::SwingState<> state{pendulum.angle, 0, 0};
  const double step = 1 / rate;
  const auto steps = std::llround(pendulum.until * rate);
  for (std::int64_t i = 1; i <= steps; ++i) {
    state = core::RungeKutta4::step(swing, state, swing(state), step).end;
    if (watch) (*watch)(static_cast<double>(i) * step, state[0]);
  }
  if (!std::isfinite(state[0])) std::abort();  // and so the loop has to be run
}

/// One of the core's adaptive methods without a run around it.
void solveByStepper(const char* method, const Pendulum& pendulum, double tolerance,
                    const Watch* watch) {
  const core::Scene scene = sceneOf(pendulum);
  const core::Body body = core::bodiesOf(scene)[0];
  core::Stepper stepper(*core::findMethod(method), scene.gravity, 0);
  core::AdaptiveStepper adaptive(stepper, tolerance);
  core::Pace pace;
  core::Piece piece;
  piece.mode = core::Mode::kSwing;
  piece.beginState[0] = pendulum.angle;
  while (piece.begin < pendulum.until) {
    piece.end = pendulum.until;
    adaptive.fill(body, piece, pace);
    piece.begin = piece.end;
    piece.beginState = piece.endState;
    if (watch) (*watch)(piece.begin, piece.beginState[0]);
  }
}

/// The reference as a whole run, which looks for impacts and turning points as well.
void solveByRun(const Pendulum& pendulum, double tolerance, const Watch* watch) {
  core::Run run(std::make_shared<const core::Scene>(sceneOf(pendulum)),
                core::referenceSolver(1, tolerance));
  while (run.time() < pendulum.until) {
    const double before = run.time();
    run.advance();
    constexpr int kLooks = 60;
    for (int i = 1; watch && i <= kLooks; ++i) {
      const double moment = before + (run.time() - before) * i / kLooks;
      (*watch)(moment, run.weightAt(0, moment).angle);
    }
  }
}

}  // namespace

core::Scene sceneOf(const Pendulum& pendulum) {
  core::Scene scene;
  scene.room = {.width = 100, .height = 100};
  scene.gravity = pendulum.pull * pendulum.length;
  core::Weight weight;
  weight.rope = core::Rope{
      .pivot = {50, 50}, .length = pendulum.length, .angle = pendulum.angle, .rigid = true};
  if (pendulum.drag > 0) {
    weight.mass *= core::dragFactor(weight, scene.airDensity) * pendulum.length / pendulum.drag;
  } else {
    scene.airDensity = 0;
  }
  scene.weights.push_back(weight);
  return scene;
}

ExactPendulum::Number ExactPendulum::value(const Number* series, Number t) {
  Number sum = 0;
  for (int k = kDegree; k >= 0; --k) sum = sum * t + series[k];
  return sum;
}

ExactPendulum::ExactPendulum(const Pendulum& pendulum) {
  constexpr Number kStep = 1.0L / 32;
  const Number pull = pendulum.pull, drag = pendulum.drag;
  Number time = 0, angle = pendulum.angle, rate = 0;
  while (time < pendulum.until) {
    Stretch& here = m_stretches.emplace_back();
    here.begin = time;
    Number sine[kDegree + 1]{std::sin(angle)}, cosine[kDegree + 1]{std::cos(angle)};
    here.angle[0] = angle;
    here.rate[0] = rate;
    const Number way = std::copysign(1.0L, rate != 0 ? rate : -angle);
    for (int k = 0; k < kDegree; ++k) {
      Number square = 0, ofSine = 0, ofCosine = 0;
      for (int j = 0; j <= k; ++j) {
        square += here.rate[j] * here.rate[k - j];
        ofSine += cosine[j] * here.rate[k - j];
        ofCosine -= sine[j] * here.rate[k - j];
      }
      here.angle[k + 1] = here.rate[k] / (k + 1);
      here.rate[k + 1] = (-pull * sine[k] - way * drag * square) / (k + 1);
      sine[k + 1] = ofSine / (k + 1);
      cosine[k + 1] = ofCosine / (k + 1);
    }
    Number step = kStep;
    if (way * value(here.rate, step) < 0) {
      // It turns within this stretch: Newton's iteration, the slope being the pull there.
      for (int i = 0; i < 30; ++i)
        step += value(here.rate, step) / (pull * std::sin(value(here.angle, step)));
      rate = 0;
    } else {
      rate = value(here.rate, step);
    }
    angle = value(here.angle, step);
    time += step;
  }
}

double ExactPendulum::at(double time) const {
  auto after = std::ranges::upper_bound(m_stretches, Number{time}, {}, &Stretch::begin);
  if (after != m_stretches.begin()) --after;
  return static_cast<double>(value(after->angle, time - after->begin));
}

std::vector<PendulumSolver> ourSolvers() {
  const auto stepper = [](const char* method) {
    return [method](const Pendulum& pendulum, double tolerance, const Watch* watch) {
      solveByStepper(method, pendulum, tolerance, watch);
    };
  };
  return {{"rk4", true, false, solveByRungeKutta},
          {"dopri5", true, true, stepper("dopri5")},
          {"reference", true, true, stepper("reference")},
          {"reference, whole run", true, true, solveByRun}};
}

std::vector<PendulumSolver> allSolvers() {
  std::vector<PendulumSolver> all = ourSolvers();
  [[maybe_unused]] const auto add = [&all](const std::vector<PendulumSolver>& others) {
    all.insert(all.end(), others.begin(), others.end());
  };
#ifdef BENCH_ODEINT
  add(odeintSolvers());
#endif
#ifdef BENCH_GSL
  add(gslSolvers());
#endif
  return all;
}

double largestError(const PendulumSolver& solver, const Pendulum& pendulum,
                    const ExactPendulum& exact, double setting) {
  double largest = 0;
  const Watch watch = [&](double time, double angle) {
    largest = std::max(largest, std::abs(angle - exact.at(time)));
  };
  try {
    solver.solve(pendulum, setting, &watch);
  } catch (const std::exception&) {
    return INFINITY;  // odeint's way to say that it cannot keep a tolerance
  }
  return largest;
}

double settingFor(const PendulumSolver& solver, const Pendulum& pendulum,
                  const ExactPendulum& exact, double error) {
  const double factor = solver.takesTolerance ? std::pow(10, -0.25) : 1.1;
  const double finest = solver.takesTolerance ? 1e-16 : 2e4;
  double setting = solver.takesTolerance ? 1e-2 : 5;
  for (; solver.takesTolerance ? setting >= finest : setting <= finest; setting *= factor) {
    // A whole number of steps.
    if (!solver.takesTolerance) setting = std::ceil(setting * pendulum.until) / pendulum.until;
    if (largestError(solver, pendulum, exact, setting) <= error) return setting;
  }
  return 0;
}

}  // namespace bench
