#include "ui/panels/runs_form.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kOfferedRuns = 2;
constexpr int kMarkSize = 16;  // px

/// How a run's weights look in the scene: filled for the first, outlines for the others.
QPixmap markOf(int run, const Theme& theme, double devicePixelRatio) {
  QPixmap mark(QSize(kMarkSize, kMarkSize) * devicePixelRatio);
  mark.setDevicePixelRatio(devicePixelRatio);
  mark.fill(Qt::transparent);
  QPainter painter(&mark);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = theme.runs[static_cast<std::size_t>(run)];
  painter.setPen(QPen(color, 2.5));
  if (run == 0) painter.setBrush(color);
  painter.drawEllipse(QRectF(2, 2, kMarkSize - 4, kMarkSize - 4));
  return mark;
}

bool isShown(const core::Scene& scene, int run) {
  return run < static_cast<int>(scene.solvers.size());
}

}  // namespace

RunsForm::RunsForm(SceneEditor* editor, QWidget* parent) : Form(editor, parent) {
  RunsForm::showDraft();
}

void RunsForm::addRun(int index) {
  Row row{new QCheckBox,
          new QLabel,
          new QComboBox,
          new QuantityField({.range = core::kStepRange, .arrowsDouble = true}),
          new QuantityField({.range = core::kToleranceRange, .arrowsTenfold = true}),
          {.method = std::string(core::methods().front().id)}};
  for (const core::Method& method : core::methods()) {
    row.method->addItem(methodWords(method), QString::fromUtf8(method.id.data()));
  }
  row.method->setFocusPolicy(Qt::TabFocus);
  ignoreWheelWithoutFocus(row.method);
  row.method->setAccessibleName(tr("Method of run %1").arg(index + 1));
  row.step->spinBox()->setAccessibleName(tr("Step of run %1").arg(index + 1));
  rows()->addRow(nameOf(row, index), row.method);
  row.tolerance->spinBox()->setAccessibleName(tr("Tolerance of run %1").arg(index + 1));
  rows()->addRow(tr("Step"), row.step);
  rows()->addRow(tr("Tolerance"), row.tolerance);
  m_runs.push_back(row);

  connect(row.shown, &QCheckBox::toggled, this, [=, this](bool on) { setShown(index, on); });
  connect(row.method, &QComboBox::activated, this,
          [=, this] { setMethod(index, row.method->currentData().toString()); });
  bindNumber(row.step, index, &core::Solver::step);
  bindNumber(row.tolerance, index, &core::Solver::tolerance);
  paintMarks();
}

void RunsForm::bindNumber(QuantityField* field, int index, double core::Solver::*number) {
  const auto read = [=, this](const core::Scene& scene) -> std::optional<double> {
    return (isShown(scene, index) ? scene.solvers[index] : m_runs[index].latest).*number;
  };
  bind(field, read,
       [=](core::Scene& scene, double value) { scene.solvers[index].*number = value; });
}

/// The run's name with the mark its weights have in the scene.
QWidget* RunsForm::nameOf(const Row& row, int index) {
  const QString words = tr("Run %1").arg(index + 1);
  row.shown->setFocusPolicy(Qt::TabFocus);
  row.shown->setAccessibleName(words);
  auto* name = new QWidget;
  auto* layout = new QHBoxLayout(name);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(row.shown);
  row.shown->setHidden(index == 0);
  layout->addWidget(row.mark);
  layout->addWidget(new QLabel(words));
  return name;
}

void RunsForm::setShown(int index, bool shown) {
  editor()->change([&](core::Scene& draft) {
    if (shown) {
      draft.solvers.push_back(m_runs[index].latest);
    } else {
      draft.solvers.erase(draft.solvers.begin() + index);
    }
  });
}

void RunsForm::setMethod(int index, const QString& id) {
  editor()->change([&](core::Scene& draft) {
    core::Solver& solver = draft.solvers[index];
    solver.method = id.toStdString();
    // Files hold no step for these: what is saved is what is shown.
    if (core::findMethod(solver.method)->isAdaptive) solver.step = core::Solver().step;
  });
}

void RunsForm::showDraft() {
  const int runCount = static_cast<int>(editor()->draft().solvers.size());
  while (static_cast<int>(m_runs.size()) < std::max(kOfferedRuns, runCount)) {
    addRun(static_cast<int>(m_runs.size()));
  }
  Form::showDraft();
  for (int i = 0; i < static_cast<int>(m_runs.size()); ++i) showRun(i);
}

void RunsForm::showRun(int index) {
  Row& row = m_runs[index];
  const bool shown = isShown(editor()->draft(), index);
  if (shown) row.latest = editor()->draft().solvers[index];
  const QSignalBlocker quiet(row.shown);
  row.shown->setChecked(shown);
  row.method->setEnabled(shown);
  row.step->setEnabled(shown);
  row.tolerance->setEnabled(shown);
  const bool isAdaptive = core::findMethod(row.latest.method)->isAdaptive;
  rows()->setRowVisible(row.step, !isAdaptive);
  rows()->setRowVisible(row.tolerance, isAdaptive);
  row.method->setCurrentIndex(row.method->findData(QString::fromStdString(row.latest.method)));
}

void RunsForm::changeEvent(QEvent* event) {
  Form::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paintMarks();
}

void RunsForm::paintMarks() {
  const Theme theme = Theme::of(palette());
  for (int i = 0; i < static_cast<int>(m_runs.size()); ++i) {
    m_runs[i].mark->setPixmap(markOf(i, theme, devicePixelRatioF()));
  }
}

}  // namespace ui
