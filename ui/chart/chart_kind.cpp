#include "ui/chart/chart_kind.h"

#include <array>

#include <QCoreApplication>

#include "ui/chart/energy_ledger.h"
#include "ui/chart/energy_over_time.h"
#include "ui/chart/height_over_time.h"
#include "ui/chart/paths.h"
#include "ui/chart/phase_portrait.h"
#include "ui/chart/speed_over_time.h"

namespace ui {

namespace {

constexpr std::array kKinds = {
    ChartKind{"energy", QT_TRANSLATE_NOOP("ui::ChartKind", "Energy"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Energies over time"), false, energyOverTime},
    ChartKind{"ledger", QT_TRANSLATE_NOOP("ui::ChartKind", "Ledger"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Where the energy is and went, stacked"), false,
              energyLedger},
    ChartKind{"phase", QT_TRANSLATE_NOOP("ui::ChartKind", "Phase"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Phase portrait: angular velocity against angle"),
              true, phasePortrait},
    ChartKind{"paths", QT_TRANSLATE_NOOP("ui::ChartKind", "Paths"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Paths of the weights: y against x"), true, paths},
    ChartKind{"height", QT_TRANSLATE_NOOP("ui::ChartKind", "Height"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Height above the floor over time"), true,
              heightOverTime},
    ChartKind{"speed", QT_TRANSLATE_NOOP("ui::ChartKind", "Speed"),
              QT_TRANSLATE_NOOP("ui::ChartKind", "Speed over time"), true, speedOverTime},
};

}  // namespace

QString ChartKind::name() const {
  return QCoreApplication::translate("ui::ChartKind", sourceName);
}

QString ChartKind::tip() const {
  return QCoreApplication::translate("ui::ChartKind", sourceTip);
}

std::span<const ChartKind> chartKinds() {
  return kKinds;
}

const ChartKind& energyChartKind() {
  return kKinds.front();
}

}  // namespace ui
