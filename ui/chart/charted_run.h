#pragma once

#include <QString>

namespace core {
class Ledger;
}

namespace ui {

/// One run's energies, with the words that name it in a legend.
struct ChartedRun {
  const core::Ledger* ledger = nullptr;
  QString name;  ///< method and step, such as "RK4, 1/60 s"
};

}  // namespace ui
