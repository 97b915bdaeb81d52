#include "ui/panels/stability_panel.h"

#include <optional>
#include <utility>

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/control/background_task.h"
#include "ui/control/file_dialog.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/control/trade_words.h"
#include "ui/files/lessons.h"
#include "ui/panels/export_message.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/task_row.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr core::Range kUntilRange{0.1, 1000, "s"};

core::MapQuantity quantityIn(const QComboBox& box) {
  return static_cast<core::MapQuantity>(box.currentData().toInt());
}

}  // namespace

/// What the other thread hands over.
struct StabilityPanel::Result {
  std::optional<std::vector<core::BoundedStep>> steps;
  std::optional<core::StabilityMap> map;
  QString sceneName;
};

StabilityPanel::StabilityPanel(SceneEditor* editor, QWidget* parent)
    : QWidget(parent),
      m_editor(editor),
      m_task(new BackgroundTask(this)),
      m_row(new TaskRow(m_task, tr("Map"))),
      m_method(new QComboBox),
      m_quantity(new QComboBox),
      m_until(new QuantityField({.range = kUntilRange, .arrowStep = 1})),
      m_export(new QToolButton),
      m_steps(new QLabel),
      m_chart(new TradeView<StabilityPlot>) {
  buildControls();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(m_row);
  layout->addWidget(m_chart, 1);
  m_chart->setAccessibleName(tr("Stability map"));
  m_chart->setAccessibleDescription(
      tr("For which steps the run keeps its energy, and for which it grows beyond all bounds"));
  m_steps->setWordWrap(true);
  m_steps->setContentsMargins(12, 6, 12, 10);
  m_steps->setAlignment(Qt::AlignTop);
  layout->addWidget(m_steps);
  layout->addStretch();
  connect(m_row, &TaskRow::startWanted, this, &StabilityPanel::compute);
  connect(editor, &SceneEditor::sceneReplaced, this, &StabilityPanel::forget);
  connect(editor, &SceneEditor::sceneChanged, this, &StabilityPanel::listQuantities);
  listQuantities();
  forget();
}

void StabilityPanel::buildControls() {
  for (const core::Method& method : core::methods()) {
    // An adaptive method chooses its steps itself.
    if (!method.isAdaptive) m_method->addItem(methodWords(method), QVariant::fromValue(&method));
  }
  m_method->setAccessibleName(tr("Method of the map"));
  m_method->setToolTip(m_method->accessibleName());
  m_quantity->setAccessibleName(tr("What the map changes besides the step"));
  m_quantity->setToolTip(m_quantity->accessibleName());
  m_until->setValue(m_time);
  m_until->setName(tr("Simulated time of each run"),
                   tr("How long each run is followed, in s: what grows slowly needs time to show"));
  connect(m_until, &QuantityField::edited, this, [this](double time) { m_time = time; });
  m_export->setText(tr("Export…"));
  m_export->setToolTip(tr("Save the map as a picture"));
  m_export->setIcon(icon("save"));
  m_export->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(m_export, &QToolButton::clicked, this, &StabilityPanel::askAndSaveMap);
  m_row->add({}, m_method);
  m_row->add(tr("Step ×"), m_quantity);
  m_row->add(tr("Simulated time"), m_until);
  m_row->addLast(m_export);
}

void StabilityPanel::listQuantities() {
  const int chosen = m_quantity->currentData().toInt();
  m_quantity->clear();
  const auto offer = [&](core::MapQuantity quantity, const QString& words) {
    if (!core::canBeMapped(*m_editor->scene(), quantity)) return;
    m_quantity->addItem(words, static_cast<int>(quantity));
  };
  offer(core::MapQuantity::kRopeLength, tr("rope length"));
  offer(core::MapQuantity::kAirDensity, tr("air density"));
  m_quantity->setCurrentIndex(qMax(0, m_quantity->findData(chosen)));
}

void StabilityPanel::compute() {
  if (m_task->isRunning()) return;
  const std::shared_ptr<const core::Scene> scene = m_editor->scene();
  const auto* method = m_method->currentData().value<const core::Method*>();
  const core::MapQuantity quantity = quantityIn(*m_quantity);
  const double until = m_time;
  auto result = std::make_shared<Result>();
  result->sceneName = titleOf(*scene);
  m_task->start(
      [=](const core::Progress& progress) {
        constexpr double kShareOfSteps = 0.1;
        result->steps = core::largestBoundedSteps(
            scene, until, [&](double share) { return progress(kShareOfSteps * share); });
        if (!result->steps) return;
        result->map = core::stabilityMap(*scene, *method, quantity, until, [&](double share) {
          return progress(kShareOfSteps + (1 - kShareOfSteps) * share);
        });
      },
      [=, this] { show(*result); });
}

void StabilityPanel::show(const Result& result) {
  m_map = std::make_shared<const core::StabilityMap>(*result.map);
  m_sceneName = result.sceneName;
  m_export->setEnabled(true);
  m_chart->show();
  m_chart->plot()->setTitle(m_sceneName);
  m_chart->plot()->setMap(m_map);
  m_steps->setText(boundedStepWords(*result.steps, m_map->until));
}

/// What was computed belongs to another scene.
void StabilityPanel::forget() {
  m_task->cancel();
  m_map.reset();
  m_export->setEnabled(false);
  m_chart->hide();
  m_chart->plot()->setTitle({});
  m_chart->plot()->setMap(nullptr);
  m_steps->setText(
      tr("Finds the largest step at which each method stays bounded, that is, makes "
         "less energy out of nothing than the scene has to move with."));
}

void StabilityPanel::askAndSaveMap() {
  const QString suggested = fileNameFrom(m_sceneName) + '-' + tr("stability") + ".png";
  const QString file = askWhereToSave(this, tr("Export stability map"), suggested, pictureKinds());
  if (!file.isEmpty()) saveMap(file);
}

void StabilityPanel::saveMap(const QString& file) {
  sayIfNotExported(this, file, writeStabilityChart(file, m_map, m_sceneName));
}

}  // namespace ui
