#include "ui/control/exports.h"

#include <utility>

#include <QDir>
#include <QFileInfo>

#include "ui/chart/chart_kind.h"
#include "ui/control/chart_size_dialog.h"
#include "ui/control/file_dialog.h"
#include "ui/control/run_controller.h"
#include "ui/control/settings.h"
#include "ui/control/warning.h"
#include "ui/files/ledger_file.h"
#include "ui/files/lessons.h"

namespace ui {
namespace {

QStringList pictureKinds() {
  return {Exports::tr("PNG picture (*.png)"), Exports::tr("SVG drawing (*.svg)"),
          Exports::tr("PDF document (*.pdf)")};
}

}  // namespace

Exports::Exports(const RunController* controller, std::function<ChartPicture()> chart,
                 QWidget* window)
    : QObject(window), m_controller(controller), m_chart(std::move(chart)), m_window(window) {}

void Exports::saveChart(const QString& file, QSizeF size) {
  report(file, writeChartPicture(file, m_chart(), {sceneName(), {}}, size));
}

void Exports::savePicture(const QString& file) {
  report(file, writeScenePicture(file, m_controller->runs(), m_controller->time(),
                                 kScenePictureSize, m_pictured()));
}

void Exports::saveLedger(const QString& file, int run) {
  report(file, writeLedgerFile(file, m_controller->recording(run).ledger()));
}

void Exports::askAndSaveChart() {
  const auto size = askChartSize(m_window, Settings().chartSize());
  if (!size) return;
  Settings().setChartSize(*size);
  const QString kind = m_chart().kind->name().toLower();
  const QString file =
      askWhereToSave(m_window, tr("Export chart"), suggested(kind, "png"), pictureKinds());
  if (!file.isEmpty()) saveChart(file, *size);
}

void Exports::askAndSavePicture() {
  const QString file = askWhereToSave(m_window, tr("Export picture of the scene"),
                                      suggested(tr("scene"), "png"), pictureKinds());
  if (!file.isEmpty()) savePicture(file);
}

void Exports::askAndSaveLedger(int run) {
  const QString what = tr("energy") + '-' + QString::fromUtf8(m_controller->run(run).method().id);
  const QString file = askWhereToSave(m_window, tr("Export energy ledger"), suggested(what, "csv"),
                                      {tr("Table (*.csv)")});
  if (!file.isEmpty()) saveLedger(file, run);
}

QString Exports::sceneName() const {
  return titleOf(m_controller->scene());
}

QString Exports::suggested(const QString& what, const QString& ending) const {
  return fileNameFrom(sceneName()) + '-' + what + '.' + ending;
}

void Exports::report(const QString& file, const QString& error) {
  if (error.isEmpty()) {
    emit done(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
    return;
  }
  warn(m_window, tr("Not exported"),
       tr("%1 was not written:\n%2").arg(QFileInfo(file).fileName(), error));
}

}  // namespace ui
