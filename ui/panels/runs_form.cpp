#include "ui/panels/runs_form.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/run_mark.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kOfferedRuns = 2;

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
          {.method = std::string(core::methods().front().id)}};
  for (const core::Method& method : core::methods()) {
    row.method->addItem(methodWords(method), QString::fromUtf8(method.id.data()));
  }
  row.method->setFocusPolicy(Qt::TabFocus);
  ignoreWheelWithoutFocus(row.method);
  row.method->setAccessibleName(tr("Method of run %1").arg(index + 1));
  row.step->spinBox()->setAccessibleName(tr("Step of run %1").arg(index + 1));
  rows()->addRow(nameOf(row, index), row.method);
  rows()->addRow(tr("Step"), row.step);
  m_runs.push_back(row);

  connect(row.shown, &QCheckBox::toggled, this, [=, this](bool on) { setShown(index, on); });
  connect(row.method, &QComboBox::activated, this,
          [=, this] { setMethod(index, row.method->currentData().toString()); });
  const auto read = [=, this](const core::Scene& scene) -> std::optional<double> {
    return isShown(scene, index) ? scene.solvers[index].step : m_runs[index].latest.step;
  };
  bind(row.step, read,
       [index](core::Scene& scene, double step) { scene.solvers[index].step = step; });
  paintMarks();
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
  editor()->change([&](core::Scene& draft) { draft.solvers[index].method = id.toStdString(); });
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
  row.method->setCurrentIndex(row.method->findData(QString::fromStdString(row.latest.method)));
}

void RunsForm::changeEvent(QEvent* event) {
  Form::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paintMarks();
}

void RunsForm::paintMarks() {
  const Theme theme = Theme::of(palette());
  for (int i = 0; i < static_cast<int>(m_runs.size()); ++i) {
    m_runs[i].mark->setPixmap(runMark(i, theme, devicePixelRatioF()));
  }
}

}  // namespace ui
