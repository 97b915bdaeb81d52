#include "ui/chart/stability_plot.h"

#include <cmath>
#include <utility>

#include <QChart>
#include <QGraphicsScene>
#include <QLineSeries>
#include <QPainter>

#include "ui/chart/chart_file.h"
#include "ui/chart/stability_grade.h"
#include "ui/control/quantity_text.h"
#include "ui/control/run_words.h"

namespace ui {
namespace {

constexpr double kSwatchWidth = 12;  // [px]

/// Half the way to the neighbours, on a logarithmic axis.
double edgeBefore(const std::vector<double>& values, std::size_t index) {
  const double here = std::log10(values[index]);
  const double ratio =
      index > 0 ? here - std::log10(values[index - 1]) : std::log10(values[1]) - here;
  return here - ratio / 2;
}

double edgeAfter(const std::vector<double>& values, std::size_t index) {
  return index + 1 < values.size() ? edgeBefore(values, index + 1)
                                   : 2 * std::log10(values[index]) - edgeBefore(values, index);
}

/// Every fourth length, each four times the one before.
LogScale lengthScale(const std::vector<double>& lengths) {
  LogScale scale;
  for (std::size_t i = 0; i < lengths.size(); i += 4) {
    scale.ticks.push_back({std::log10(lengths[i]), prefixedText(lengths[i], QStringLiteral("m"))});
  }
  return scale;
}

/// Powers of ten.
LogScale densityScale(const std::vector<double>& densities) {
  LogScale scale;
  for (int power = -1; std::pow(10, power) <= densities.back(); ++power) {
    scale.ticks.push_back({double(power), quantityText(std::pow(10, power))});
  }
  return scale;
}

std::vector<HeadingEntry> legend() {
  std::vector<HeadingEntry> entries;
  for (const StabilityGrade grade : kStabilityGrades) {
    HeadingEntry entry;
    entry.line = QPen(colorOf(grade), kSwatchWidth, Qt::SolidLine, Qt::FlatCap);
    entry.text = wordsFor(grade);
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace

/// The colored cells, over the chart's plot.
class StabilityPlot::Cells : public QGraphicsItem {
 public:
  explicit Cells(QChart* chart) : QGraphicsItem(chart) { setZValue(1); }

  void place(const QRectF& area, const core::StabilityMap* map) {
    prepareGeometryChange();
    m_area = area;
    m_map = map;
    update();
  }

  QRectF boundingRect() const override { return m_area; }

  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    if (!m_map) return;
    painter->setPen(Qt::NoPen);
    painter->setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t value = 0; value < m_map->values.size(); ++value) {
      for (std::size_t step = 0; step < m_map->steps.size(); ++step) {
        const auto& cell = m_map->cell(step, value);
        if (cell) painter->fillRect(rectOf(step, value), colorOf(gradeOf(*cell)));
      }
    }
  }

 private:
  QRectF rectOf(std::size_t step, std::size_t value) const {
    const auto share = [](const std::vector<double>& values, double edge) {
      const double first = edgeBefore(values, 0), last = edgeAfter(values, values.size() - 1);
      return (edge - first) / (last - first);
    };
    const double left = share(m_map->steps, edgeBefore(m_map->steps, step));
    const double right = share(m_map->steps, edgeAfter(m_map->steps, step));
    const double bottom = share(m_map->values, edgeBefore(m_map->values, value));
    const double top = share(m_map->values, edgeAfter(m_map->values, value));
    // On whole pixels, or seams show.
    return QRectF(QPointF(std::round(m_area.left() + left * m_area.width()),
                          std::round(m_area.bottom() - top * m_area.height())),
                  QPointF(std::round(m_area.left() + right * m_area.width()),
                          std::round(m_area.bottom() - bottom * m_area.height())));
  }

  QRectF m_area;
  const core::StabilityMap* m_map = nullptr;
};

StabilityPlot::StabilityPlot(QChart* chart)
    : QObject(chart), m_chart(chart), m_frame(new LogFrame(chart)), m_cells(new Cells(chart)) {
  connect(m_frame, &LogFrame::resized, this, &StabilityPlot::showScales);
  connect(chart, &QChart::plotAreaChanged, this, &StabilityPlot::placeCells);
}

StabilityPlot::~StabilityPlot() = default;

void StabilityPlot::setLook(const ChartLook& look) {
  m_frame->setLook(look);
  update();
}

void StabilityPlot::setTitle(const QString& title) {
  m_title = title;
  update();
}

void StabilityPlot::setMap(std::shared_ptr<const core::StabilityMap> map) {
  m_map = std::move(map);
  update();
}

void StabilityPlot::update() {
  m_frame->removeCurves();
  HeadingContent heading;
  heading.title = m_title;
  if (m_map) {
    heading.note = tr("%1, each run over %2 s. Drift as a share of the energy the scene has to "
                      "move with; empty: the weights do not fit the room.")
                       .arg(methodWords(*m_map->method))
                       .arg(m_map->until);
    heading.legend = legend();
    // Without a curve Qt shows no axes.
    m_frame->add(new QLineSeries);
  }
  m_frame->setHeading(std::move(heading));
  showScales();
  placeCells();
}

void StabilityPlot::showScales() {
  if (!m_map) return;
  const auto around = [](LogScale scale, const std::vector<double>& values) {
    scale.lowest = edgeBefore(values, 0);
    scale.highest = edgeAfter(values, values.size() - 1);
    return scale;
  };
  const std::vector<double>& steps = m_map->steps;
  const std::vector<double>& values = m_map->values;
  m_frame->setHorizontal(
      around(stepScale(steps.front(), steps.back(), m_frame->horizontalLabels()), steps),
      tr("Step"));
  const bool isLength = m_map->quantity == core::MapQuantity::kRopeLength;
  m_frame->setVertical(around(isLength ? lengthScale(values) : densityScale(values), values),
                       isLength ? tr("Length of the longest rope") : tr("Air density (kg/m³)"));
}

void StabilityPlot::placeCells() {
  m_cells->place(m_chart->plotArea(), m_map.get());
}

QString writeStabilityChart(const QString& file, std::shared_ptr<const core::StabilityMap> map,
                            const QString& title) {
  QGraphicsScene scene;
  auto* chart = new QChart;
  scene.addItem(chart);
  auto* plot = new StabilityPlot(chart);
  plot->setLook(ChartLook::forPaper());
  plot->setTitle(title);
  plot->setMap(std::move(map));
  return writeChart(*chart, file, title, QSizeF(200, 125));
}

}  // namespace ui
