#pragma once

#include <array>
#include <functional>

namespace bench {

/// What moves a batch of weights.
enum class Motion { kFlight, kSwing };

constexpr double kGravity = 9.81;    // [m/s²]
constexpr double kBatchStep = 1e-4;  // [s]: so short that nothing decays while it is timed
constexpr double kDrag = 0.0226;     // q [1/m], ropes are 1 m long

/// Where weight i of a batch starts: (x, y, v_x, v_y) [m, m/s], or (θ, –, ω, –) [rad, rad/s].
inline std::array<double, 4> startOf(int i) {
  return {1 + 0.001 * (i % 1000), 1, 0.5 + 0.01 * (i % 100), 2};
}

/// Takes one step of a batch.
using BatchStep = std::function<void()>;

/// Odeint's Runge–Kutta 4 over one flat vector, places first, compiled for the same processors
/// as ours.
BatchStep odeintBatch(int count, Motion motion);

}  // namespace bench
