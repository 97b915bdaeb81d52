#include "ui/files/ledger_file.h"

#include <QSaveFile>

#include "core/recording/csv.h"

namespace ui {

QString writeLedgerFile(const QString& file, const core::Ledger& ledger) {
  std::string csv(core::energyHeader());
  for (const core::EnergySample& sample : ledger.samples()) {
    core::appendEnergyRow(csv, sample.time, sample.energies);
  }
  QSaveFile output(file);
  if (!output.open(QIODevice::WriteOnly)) return output.errorString();
  output.write(csv.data(), static_cast<qint64>(csv.size()));
  return output.commit() ? QString() : output.errorString();
}

}  // namespace ui
