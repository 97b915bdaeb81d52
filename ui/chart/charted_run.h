#pragma once

#include <QString>

namespace core {
class Ledger;
class MotionLog;
}  // namespace core

namespace ui {

/// One run's history, with the words that name it in a legend.
struct ChartedRun {
  const core::Ledger* ledger = nullptr;
  QString name;                             ///< method and step, such as "RK4, 1/60 s"
  const core::MotionLog* motion = nullptr;  ///< null: no charts of single weights
};

}  // namespace ui
