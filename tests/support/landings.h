#pragma once

#include "core/aim/landing_finder.h"

namespace tests {

/// Finds where a weight lands that is cut by `until` at the latest [s].
///
/// @param wait  longest time from the cut to the landing [s]
inline core::LandingFinder finderFor(const core::Scene& scene, const core::Solver& solver,
                                     int weight, double until, double wait) {
  core::LandingFinder finder(scene, solver, weight, wait);
  core::WorkMeter meter(1, {});
  finder.hangUntil(until, meter);
  return finder;
}

inline core::Landing landingIn(const core::LandingFinder& finder, double cutTime) {
  core::WorkMeter meter(1, {});
  return *finder.landing(cutTime, meter);
}

/// The scene with its first weight so light, and hurled through air so thick, that Euler's
/// method is beyond all numbers within a second at steps of 0.1 s.
inline core::Scene beyondNumbers(core::Scene scene) {
  scene.airDensity = 2000;
  scene.weights[0].mass = 1e-6;
  scene.weights[0].radius = 0.4;
  scene.weights[0].rope->angularVelocity = 100;
  return scene;
}

}  // namespace tests
