#include "ui/chart/work_precision_export.h"

#include <utility>

#include <QChart>
#include <QGraphicsScene>

#include "ui/chart/chart_file.h"

namespace ui {

QString writeWorkPrecisionChart(const QString& file,
                                std::shared_ptr<const core::Measurement> measurement,
                                ErrorAgainst against, const QString& title, QSizeF size) {
  QGraphicsScene scene;
  auto* chart = new QChart;
  scene.addItem(chart);
  auto* plot = new WorkPrecisionPlot(chart);
  plot->setLook(ChartLook::forPaper());
  plot->setTitle(title);
  plot->setAgainst(against);
  plot->setMeasurement(std::move(measurement));
  return writeChart(*chart, file, title, size);
}

}  // namespace ui
