#include "app/energy_history.h"

#include <algorithm>
#include <initializer_list>

#include <QCoreApplication>

#include "core/run/run.h"

namespace app {

namespace {

constexpr int kTableRows = 10;  // besides the one at the start
constexpr int kColumnWidth = 12;

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::EnergyHistory)
};

QString columns(std::initializer_list<QString> words) {
  QString line;
  for (const QString& word : words) line += word.rightJustified(kColumnWidth);
  return line + '\n';
}

QString rowText(const core::EnergySample& sample) {
  const auto text = [](double number) { return QString::number(number, 'g', 5); };
  const core::Energies& energies = sample.energies;
  return columns({text(sample.time), text(energies.kinetic), text(energies.potential),
                  text(energies.lostToAir), text(energies.lostToImpacts),
                  text(energies.lostToRopes), text(energies.lostToFriction),
                  text(energies.numericalDrift)});
}

}  // namespace

EnergyHistory::EnergyHistory(double until)
    : m_until(until), m_tableClock(until > 0 ? until / kTableRows : 1, until) {}

void EnergyHistory::record(const core::Run& run) {
  for (; m_tableClock.isDue(run.time()); m_tableClock.next()) {
    const double time = m_tableClock.moment();
    m_tableRows.push_back({time, run.energiesAt(time)});
  }
  const double time = std::min(run.time(), m_until);
  m_ledger.append({time, run.energiesAt(time)});
}

QString EnergyHistory::table() const {
  QString text = Texts::tr(
      "Time in s; energies in J: kinetic, potential, lost to air, to impacts, to "
      "ropes, to friction; numerical drift\n");
  text += columns({Texts::tr("time"), Texts::tr("kinetic"), Texts::tr("potential"),
                   Texts::tr("air"), Texts::tr("impacts"), Texts::tr("ropes"),
                   Texts::tr("friction"), Texts::tr("drift")});
  for (const core::EnergySample& sample : m_tableRows) text += rowText(sample);
  return text;
}

}  // namespace app
