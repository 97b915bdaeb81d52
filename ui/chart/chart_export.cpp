#include "ui/chart/chart_export.h"

#include <QChart>
#include <QGraphicsScene>

#include "ui/chart/chart_file.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_plot.h"

namespace ui {

namespace {

/// The picture laid out for paper, in a scene of its own.
class PaperChart {
 public:
  PaperChart(const ChartPicture& picture, const ChartCaption& caption) : m_chart(new QChart) {
    m_scene.addItem(m_chart);
    auto* plot = new ChartPlot(m_chart);
    plot->setTitle(caption.title, caption.note);
    plot->setLook(ChartLook::forPaper());
    plot->setSubject(*picture.kind, picture.subject);
    plot->setHidden(picture.hidden);
    plot->setZoom(picture.zoom);
  }

  QChart& chart() { return *m_chart; }

 private:
  QGraphicsScene m_scene;
  QChart* m_chart;  // owned by the scene
};

}  // namespace

QString writeChartPicture(const QString& file, const ChartPicture& picture,
                          const ChartCaption& caption, QSizeF size) {
  return writeChart(PaperChart(picture, caption).chart(), file, caption.title, size);
}

QImage chartImage(const ChartPicture& picture, const ChartCaption& caption, QSizeF size) {
  return chartImage(PaperChart(picture, caption).chart(), size);
}

QString writeEnergyChart(const QString& file, const std::vector<ChartedRun>& runs,
                         const ChartCaption& caption, QSizeF size) {
  return writeChartPicture(file, {&energyChartKind(), {runs, nullptr, {}}, {}, {}}, caption, size);
}

}  // namespace ui
