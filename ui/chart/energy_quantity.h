#pragma once

#include <cstddef>
#include <span>

#include <QColor>
#include <QString>

namespace core {
struct Energies;
}

namespace ui {

struct Theme;

/// One curve of the energy ledger: what it shows, and how it looks in every chart.
struct EnergyQuantity {
  const char* sourceName;  ///< English, for translation
  double (*of)(const core::Energies&);
  QColor Theme::*color;
  double width;         ///< of the line [px]
  bool holdsPotential;  ///< moves with the height that counts as zero
  bool shownWhenZero;

  QString name() const;
};

inline constexpr std::size_t kEnergyQuantityCount = 7;

/// In the order of legends; the total is the last, and drawn on top.
std::span<const EnergyQuantity, kEnergyQuantityCount> energyQuantities();

}  // namespace ui
