#include "ui/chart/stability_grade.h"

#include <QCoreApplication>

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::StabilityPlot)
};

// Shares of the energy the scene has to move with.
constexpr double kExactDrift = 0.01;
constexpr double kFairDrift = 0.1;

}  // namespace

StabilityGrade gradeOf(const core::BoundednessTrial& trial) {
  switch (trial.outcome) {
    case core::Boundedness::kBounded:
      break;
    case core::Boundedness::kRunaway:
      return StabilityGrade::kRunaway;
    case core::Boundedness::kDiverged:
      return StabilityGrade::kDiverged;
  }
  if (trial.drift < kExactDrift) return StabilityGrade::kExact;
  return trial.drift < kFairDrift ? StabilityGrade::kFair : StabilityGrade::kPoor;
}

QColor colorOf(StabilityGrade grade) {
  switch (grade) {
    case StabilityGrade::kExact:
      return QColor("#d7eefb");
    case StabilityGrade::kFair:
      return QColor("#7cc4ec");
    case StabilityGrade::kPoor:
      return QColor("#2b83ba");
    case StabilityGrade::kRunaway:
      return QColor("#c2410c");
    case StabilityGrade::kDiverged:
      return QColor("#8f1157");
  }
  return {};
}

QString wordsFor(StabilityGrade grade) {
  switch (grade) {
    case StabilityGrade::kExact:
      return Words::tr("drift under 1 %");
    case StabilityGrade::kFair:
      return Words::tr("under 10 %");
    case StabilityGrade::kPoor:
      return Words::tr("up to 100 %");
    case StabilityGrade::kRunaway:
      return Words::tr("energy more than doubled");
    case StabilityGrade::kDiverged:
      return Words::tr("diverged");
  }
  return {};
}

}  // namespace ui
