#include "ui/chart/energy_quantity.h"

#include <array>

#include <QCoreApplication>

#include "core/motion/energy.h"
#include "ui/style/theme.h"

namespace ui {

namespace {

using core::Energies;

constexpr double kThin = 2;
constexpr double kBold = 3;

constexpr std::array<EnergyQuantity, kEnergyQuantityCount> kQuantities = {{
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Kinetic"), [](const Energies& e) { return e.kinetic; },
     &Theme::kinetic, kThin, false, true},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Potential"),
     [](const Energies& e) { return e.potential; }, &Theme::potential, kThin, true, true},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Lost to air"),
     [](const Energies& e) { return e.lostToAir; }, &Theme::lostToAir, kThin, false, true},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Lost to impacts"),
     [](const Energies& e) { return e.lostToImpacts; }, &Theme::lostToImpacts, kThin, false, true},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Lost to ropes"),
     [](const Energies& e) { return e.lostToRopes; }, &Theme::lostToRopes, kThin, false, false},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Lost to friction"),
     [](const Energies& e) { return e.lostToFriction; }, &Theme::lostToFriction, kThin, false,
     false},
    {QT_TRANSLATE_NOOP("ui::EnergyChart", "Total"), [](const Energies& e) { return e.accounted(); },
     &Theme::total, kBold, true, true},
}};

}  // namespace

QString EnergyQuantity::name() const {
  return QCoreApplication::translate("ui::EnergyChart", sourceName);
}

std::span<const EnergyQuantity, kEnergyQuantityCount> energyQuantities() {
  return kQuantities;
}

}  // namespace ui
