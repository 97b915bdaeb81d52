#pragma once

#include <memory>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/run/event.h"
#include "core/run/run.h"
#include "core/scene/scene.h"

namespace tests {

/// A scene at one moment.
struct Moment {
  double time = 0;                         ///< [s]
  core::Energies energies;                 ///< without drift in an exact answer
  std::vector<core::WeightState> weights;  ///< without tensions in an exact answer
};

/// A scene over time: exactly, or as a run shows it.
struct Course {
  std::vector<Moment> moments;      ///< at the times asked for
  std::vector<core::Event> events;  ///< up to the last of them, in time order
};

/// A scene with an answer that is exact to the last digit printed.
struct ReferenceCase {
  QString name;  ///< of its file, without ending
  std::shared_ptr<const core::Scene> scene;
  Course exact;
};

/// Names of all cases in tests/reference, in alphabetical order.
QStringList referenceNames();

/// The case of that name; ends the test program with a message where it cannot be read.
ReferenceCase referenceCase(const QString& name);

/// What a run of the case's scene shows at the moments its answer is known for.
Course simulated(const ReferenceCase& reference, const core::Solver& solver);

/// Largest distance of any weight from its exact place at any of the moments [m].
double positionError(const ReferenceCase& reference, const Course& course);

}  // namespace tests
