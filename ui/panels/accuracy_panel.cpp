#include "ui/panels/accuracy_panel.h"

#include <array>
#include <optional>
#include <utility>

#include <QComboBox>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/trade/measurement_csv.h"
#include "ui/chart/log_scale.h"
#include "ui/chart/work_precision_export.h"
#include "ui/control/background_task.h"
#include "ui/control/file_dialog.h"
#include "ui/control/scene_editor.h"
#include "ui/control/trade_words.h"
#include "ui/files/lessons.h"
#include "ui/files/output_file.h"
#include "ui/panels/export_button.h"
#include "ui/panels/export_message.h"
#include "ui/panels/measurement_table.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/task_row.h"

namespace ui {
namespace {

constexpr core::Range kUntilRange{0.1, 1e6, "s"};
// Bounds of the error to choose from [m].
constexpr std::array kErrors{0.1, 0.01, 1e-3, 1e-4, 1e-6, 1e-9};
constexpr int kFirstError = 2;

}  // namespace

AccuracyPanel::AccuracyPanel(SceneEditor* editor, QWidget* parent)
    : QWidget(parent),
      m_editor(editor),
      m_task(new BackgroundTask(this)),
      m_row(new TaskRow(m_task, tr("Measure"))),
      m_until(new QuantityField({.range = kUntilRange, .arrowStep = 1})),
      m_against(new QComboBox),
      m_error(new QComboBox),
      m_export(
          new ExportButton([this] { return fileNameFrom(m_sceneName) + '-' + tr("accuracy"); })),
      m_chart(new TradeView<WorkPrecisionPlot>),
      m_table(new MeasurementTable),
      m_results(resultArea()),
      m_found(new QLabel) {
  buildControls();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_row);
  layout->addWidget(m_results, 1);
  m_found->setWordWrap(true);
  m_found->setAlignment(Qt::AlignTop);
  m_found->setContentsMargins(12, 6, 12, 10);
  layout->addWidget(m_found);
  layout->addStretch();
  connect(m_chart->plot(), &WorkPrecisionPlot::pointPicked, this, &AccuracyPanel::picked);
  connect(m_table, &MeasurementTable::rowPicked, this, &AccuracyPanel::picked);
  connect(m_export, &ExportButton::chartWanted, this, &AccuracyPanel::saveChart);
  connect(m_export, &ExportButton::tableWanted, this, &AccuracyPanel::saveTable);
  connect(m_row, &TaskRow::startWanted, this, [this] { measure(m_time); });
  connect(editor, &SceneEditor::sceneReplaced, this, &AccuracyPanel::forget);
  forget();
}

void AccuracyPanel::buildControls() {
  m_until->setValue(m_time);
  m_until->setName(tr("Simulated time"),
                   tr("How long each run is followed, in s; errors are compared at its end"));
  connect(m_until, &QuantityField::edited, this, [this](double time) { m_time = time; });
  m_against->addItems({tr("Error against cost"), tr("Error against step")});
  m_against->setAccessibleName(tr("What the chart shows"));
  m_against->setToolTip(
      tr("Cost is counted in slope evaluations, which the time of computing goes with"));
  connect(m_against, &QComboBox::currentIndexChanged, this, &AccuracyPanel::showAgainst);
  for (const double error : kErrors) {
    m_error->addItem(prefixedText(error, QStringLiteral("m")), error);
  }
  m_error->setCurrentIndex(kFirstError);
  m_error->setAccessibleName(tr("Right within"));
  m_error->setToolTip(
      tr("Largest distance from the true place that is accepted, in m: which "
         "method reaches it at the lowest cost?"));
  connect(m_error, &QComboBox::currentIndexChanged, this, &AccuracyPanel::showFound);
  m_row->add(tr("Simulated time"), m_until);
  m_row->addLast(m_against);
  m_row->addLast(new QLabel(tr("Right within")));
  m_row->addLast(m_error);
  m_row->addLast(m_export);
}

QSplitter* AccuracyPanel::resultArea() {
  auto* splitter = new QSplitter(Qt::Horizontal);
  m_chart->setAccessibleName(tr("Error against cost or step"));
  m_chart->setToolTip(tr("Click a point to open it as a run"));
  splitter->addWidget(m_chart);
  splitter->addWidget(m_table);
  return splitter;
}

void AccuracyPanel::measure(double until) {
  if (m_task->isRunning()) return;
  const std::shared_ptr<const core::Scene> scene = m_editor->scene();
  auto result = std::make_shared<std::optional<core::Measurement>>();
  m_task->start(
      [=](const core::Progress& progress) {
        *result = core::measure(scene, core::measuredSolvers(), until, progress);
      },
      [=, this] {
        show(std::make_shared<const core::Measurement>(std::move(**result)), titleOf(*scene));
      });
}

void AccuracyPanel::show(std::shared_ptr<const core::Measurement> measurement,
                         const QString& sceneName) {
  m_measurement = std::move(measurement);
  m_sceneName = sceneName;
  m_export->setEnabled(true);
  m_chart->plot()->setTitle(sceneName);
  m_chart->plot()->setMeasurement(m_measurement);
  m_table->setMeasurement(*m_measurement);
  if (m_results->isHidden()) divideRoom();
  m_results->show();
  showFound();
}

/// The chart gets most of it, but the table what its first columns need.
void AccuracyPanel::divideRoom() {
  const int all = contentsRect().width() - m_results->handleWidth();
  const int table = std::clamp(m_table->widthOfFirstColumns(), 2 * all / 5, all / 2);
  m_results->setSizes({all - table, table});
}

/// What was measured belongs to another scene.
void AccuracyPanel::forget() {
  m_task->cancel();
  m_measurement.reset();
  m_export->setEnabled(false);
  m_results->hide();
  m_chart->plot()->setTitle({});
  m_chart->plot()->setMeasurement(nullptr);
  m_table->setMeasurement({});
  showFound();
}

void AccuracyPanel::showAgainst() {
  m_chart->plot()->setAgainst(m_against->currentIndex() == 0 ? ErrorAgainst::kCost
                                                             : ErrorAgainst::kStep);
}

void AccuracyPanel::showFound() {
  m_found->setText(m_measurement
                       ? foundWords(*m_measurement, m_error->currentData().toDouble())
                       : tr("Measures every method at steps from 1/8 to 1/8192 s: how far the "
                            "weights are from where they really are, and what that costs. Takes "
                            "some seconds."));
}

void AccuracyPanel::saveChart(const QString& file) {
  const ErrorAgainst against =
      m_against->currentIndex() == 0 ? ErrorAgainst::kCost : ErrorAgainst::kStep;
  sayIfNotExported(this, file, writeWorkPrecisionChart(file, m_measurement, against, m_sceneName));
}

void AccuracyPanel::saveTable(const QString& file) {
  sayIfNotExported(this, file, writeWhole(file, core::measurementCsv(*m_measurement)));
}

}  // namespace ui
