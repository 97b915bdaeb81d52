#include "ui/chart/chart_export.h"

#include <QChart>
#include <QGraphicsScene>

#include "ui/chart/chart_file.h"
#include "ui/chart/energy_plot.h"

namespace ui {

QString writeEnergyChart(const QString& file, const std::vector<ChartedRun>& runs,
                         const ChartCaption& caption, QSizeF size) {
  QGraphicsScene scene;
  auto* chart = new QChart;
  scene.addItem(chart);
  auto* plot = new EnergyPlot(chart);
  plot->setTitle(caption.title, caption.note);
  plot->setLook(ChartLook::forPaper());
  plot->setRuns(runs);
  return writeChart(*chart, file, caption.title, size);
}

}  // namespace ui
