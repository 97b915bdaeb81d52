#pragma once

#include <memory>
#include <optional>

#include "core/scene/scene.h"
#include "core/trade/sampled_course.h"
#include "core/trade/work_meter.h"

namespace core {

/// Where the weights of a scene really are, as far as that can be told.
///
/// After impacts errors may grow like e^(λt), and from some moment on no computation in double
/// precision knows the answer. The reference solution is therefore computed twice, at two
/// tolerances and from starts that differ in the last digit (where nothing bends the paths,
/// rounding is all there is to grow), and trusted while the two agree.
///
/// Weights that lean on each other move by time-stepping of first order in the reference as well
/// (core/model.md, "Rest"): once groups have formed, errors are differences from that.
struct TrustedCourse {
  SampleTimes times;
  SampledCourse course;    ///< by the finer tolerance, up to the last moment that is trusted
  double uncertainty = 0;  ///< largest distance between the two up to there [m]

  /// The last moment that is trusted [s].
  double until() const { return times.at(course.count() - 1); }
};

/// The two reference solutions agree to this in every weight's place [m].
inline constexpr double kTrustedAgreement = 1e-6;

/// @param until     [s], ≥ 0
/// @param progress  may be empty
/// @return          nothing if the progress stopped it
/// @pre problemsIn(*scene) is empty
std::optional<TrustedCourse> trustedCourse(const std::shared_ptr<const Scene>& scene, double until,
                                           const Progress& progress = {});

}  // namespace core
