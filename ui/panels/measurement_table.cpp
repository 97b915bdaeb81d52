#include "ui/panels/measurement_table.h"

#include <QHeaderView>
#include <QScrollBar>

#include "ui/chart/log_scale.h"
#include "ui/control/quantity_text.h"
#include "ui/control/run_words.h"
#include "ui/control/trade_words.h"

namespace ui {
namespace {

constexpr double kNanoseconds = 1e-9;  // [s]
constexpr int kTime = 4;               // the column

QString quantity(double value, const QString& symbol) {
  return value > 0 ? prefixedText(value, symbol) : QStringLiteral("0 ") + symbol;
}

}  // namespace

MeasurementTable::MeasurementTable(QWidget* parent) : QTableWidget(parent) {
  const QStringList headings{tr("Method"), tr("Setting"), tr("Error"),  tr("Drift"),
                             tr("Time/s"), tr("Slopes"),  tr("Outcome")};
  setColumnCount(static_cast<int>(headings.size()));
  setHorizontalHeaderLabels(headings);
  const QStringList tips{tr("Method"),
                         tr("Step, or tolerance of an adaptive method"),
                         tr("Largest distance of any weight from where it really is"),
                         tr("Largest numerical drift of the energy"),
                         tr("Computing time per simulated second"),
                         tr("Slope evaluations"),
                         tr("Whether the run came to the end")};
  for (int i = 0; i < tips.size(); ++i) horizontalHeaderItem(i)->setToolTip(tips[i]);
  verticalHeader()->hide();
  horizontalHeader()->setStretchLastSection(true);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);  // Tab leaves it again
  setAlternatingRowColors(true);
  setAccessibleName(tr("Measured points"));
  setToolTip(tr("Double-click a row, or press Return, to open it as a run"));
  setAccessibleDescription(toolTip());
  connect(this, &QTableWidget::cellActivated, this,
          [this](int row) { emit rowPicked(m_solvers[static_cast<std::size_t>(row)]); });
}

void MeasurementTable::setMeasurement(const core::Measurement& measurement) {
  setRowCount(0);
  m_solvers.clear();
  for (const core::MethodCurve& curve : measurement.curves) {
    for (const core::MeasuredPoint& point : curve.points) addRow(point);
  }
  resizeColumnsToContents();
}

int MeasurementTable::widthOfFirstColumns() const {
  const QHeaderView* header = horizontalHeader();
  const int end = header->sectionPosition(kTime) + header->sectionSize(kTime);
  return end + verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
}

void MeasurementTable::addRow(const core::MeasuredPoint& point) {
  const QString outcome =
      point.isComplete() ? tr("ok") : tr("diverged at %1 s").arg(quantityText(point.reached));
  const QStringList texts{
      methodWords(*core::findMethod(point.solver.method)),
      settingWords(point.solver),
      quantity(point.maxPositionError, QStringLiteral("m")),
      quantity(point.maxEnergyDrift, QStringLiteral("J")),
      quantity(kNanoseconds * point.nanosecondsPerSimulatedSecond, QStringLiteral("s")),
      QLocale().toString(static_cast<qlonglong>(point.evaluations)),
      outcome};
  const int row = rowCount();
  insertRow(row);
  for (int column = 0; column < texts.size(); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    const bool isFigure = 0 < column && column + 1 < texts.size();
    item->setTextAlignment(Qt::AlignVCenter | (isFigure ? Qt::AlignRight : Qt::AlignLeft));
    setItem(row, column, item);
  }
  m_solvers.push_back(point.solver);
}

}  // namespace ui
