#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "core/motion/lanes.h"
#include "tests/bench/peers/batches.h"

namespace bench {
namespace {

using State = std::vector<double>;
using Stepper = boost::numeric::odeint::runge_kutta4<State>;

struct Flights {
  void operator()(const State& x, State& slope, double /*time*/) const {
    const std::size_t count = x.size() / 4;
    const double *vx = x.data() + 2 * count, *vy = vx + count;
    double *dx = slope.data(), *dy = dx + count, *dvx = dy + count, *dvy = dvx + count;
    for (std::size_t i = 0; i < count; ++i) {
      const double drag = kDrag * std::sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
      dx[i] = vx[i];
      dy[i] = vy[i];
      dvx[i] = -drag * vx[i];
      dvy[i] = -kGravity - drag * vy[i];
    }
  }
};

struct Swings {
  void operator()(const State& x, State& slope, double /*time*/) const {
    const std::size_t count = x.size() / 2;
    const double *angle = x.data(), *rate = angle + count;
    double *dAngle = slope.data(), *dRate = dAngle + count;
    for (std::size_t i = 0; i < count; ++i) {
      dAngle[i] = rate[i];
      dRate[i] = -kGravity * std::sin(angle[i]) - kDrag * std::abs(rate[i]) * rate[i];
    }
  }
};

CORE_VECTOR_SPEED
void stepFlights(Stepper& stepper, State& state) {
  stepper.do_step(Flights(), state, 0.0, kBatchStep);
}

CORE_VECTOR_SPEED
void stepSwings(Stepper& stepper, State& state) {
  stepper.do_step(Swings(), state, 0.0, kBatchStep);
}

struct Batch {
  Stepper stepper;
  State state;
};

}  // namespace

BatchStep odeintBatch(int count, Motion motion) {
  const int entries = motion == Motion::kFlight ? 4 : 2;
  auto batch = std::make_shared<Batch>();
  batch->state.resize(static_cast<std::size_t>(entries) * count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < entries; ++k)
      batch->state[static_cast<std::size_t>(k) * count + i] = startOf(i)[4 / entries * k];
  if (motion == Motion::kFlight) return [batch] { stepFlights(batch->stepper, batch->state); };
  return [batch] { stepSwings(batch->stepper, batch->state); };
}

}  // namespace bench
