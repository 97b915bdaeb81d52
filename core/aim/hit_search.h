#pragma once

#include <optional>
#include <vector>

#include "core/aim/cut_sweep.h"

namespace core {

/// Looks for the cut times that hit a target, along the landings of a sweep.
class HitSearch {
 public:
  /// @param sharpness  jumps of the curve are enclosed in less than that [s]
  HitSearch(const LandingFinder& finder, const Target& target, double sharpness, WorkMeter& meter)
      : m_finder(finder), m_target(target), m_sharpness(sharpness), m_meter(meter) {}

  /// @param landings  in order of cut times
  /// @return          false if the meter stopped it
  bool lookThrough(const std::vector<Landing>& landings);

  std::vector<Hit> hits() const { return m_hits; }
  /// Landings found on the way that are unlike those on both sides: the curve is not known well
  /// enough there.
  const std::vector<Landing>& surprises() const { return m_surprises; }

 private:
  void lookBetween(const Landing& a, const Landing& b);
  std::optional<Landing> crossing(Landing a, Landing b, double place);
  void cross(const Landing& landing, double line, bool isEastward);
  void consider(const Landing& landing);
  void open(const Landing& landing);
  void close(const Landing& landing);

  const LandingFinder& m_finder;
  Target m_target;
  double m_sharpness;
  WorkMeter& m_meter;
  std::optional<Hit> m_open;  // the landing is on the target
  std::vector<Hit> m_hits;
  std::vector<Landing> m_surprises;
  bool m_goesOn = true;
};

}  // namespace core
