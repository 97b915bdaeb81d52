#include "ui/panels/runs_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "core/trade/reference.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/run_mark.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kArrowsWidth = 36;  // of a field's arrows and margins [px]

enum Column { kMethodColumn = 1, kStepColumn };

/// What a run begins with when it is switched on for the first time: what the program is
/// about comes first, and the last is what all can be judged by.
core::Solver firstSolver(int index) {
  if (index == core::kMostSolvers - 1) return core::referenceSolver(core::Solver().step);
  return {.method = index == 2 ? "semi-implicit-euler" : "euler"};
}

bool isShown(const core::Scene& scene, int run) {
  return run < static_cast<int>(scene.solvers.size());
}

}  // namespace

RunsForm::RunsForm(SceneEditor* editor, QWidget* parent)
    : Form(editor, parent), m_grid(new QGridLayout) {
  m_grid->setHorizontalSpacing(6);
  m_grid->setVerticalSpacing(6);
  m_grid->setColumnStretch(kMethodColumn, 1);
  rows()->addRow(m_grid);
  addHeadings();
  for (int i = 0; i < core::kMostSolvers; ++i) addRun(i);
  paintMarks();
  sizeFields();
  RunsForm::showDraft();
}

void RunsForm::addHeadings() {
  auto* method = new QLabel(tr("Method"));
  method->setToolTip(methodMeaning());
  m_grid->addWidget(method, 0, kMethodColumn);
  auto* step = new QLabel(tr("Step, tolerance"));
  step->setToolTip(stepMeaning() + '\n' + toleranceMeaning());
  m_grid->addWidget(step, 0, kStepColumn);
}

QString RunsForm::methodMeaning() {
  return tr(
      "How the run gets from one moment to the next. The error of a method of order p "
      "shrinks with the step h like h to the power of p.");
}

QString RunsForm::stepMeaning() {
  return tr(
      "Step h in s: how much simulated time the method takes at once. Smaller steps are "
      "more exact and cost more.");
}

QString RunsForm::toleranceMeaning() {
  return tr(
      "Tolerance, without unit: the error the method allows itself in a step, in m, m/s, rad and "
      "rad/s. It chooses its steps accordingly.");
}

void RunsForm::addRun(int index) {
  m_runs.push_back({new QCheckBox, new QLabel, new QComboBox,
                    new QuantityField({.range = core::kStepRange, .arrowsDouble = true}),
                    new QuantityField({.range = core::kToleranceRange, .arrowsTenfold = true}),
                    firstSolver(index)});
  const Row& row = m_runs.back();
  fillMethods(row.method, index);
  m_grid->addWidget(nameOf(row, index), index + 1, 0);
  m_grid->addWidget(row.method, index + 1, kMethodColumn);
  m_grid->addWidget(row.step, index + 1, kStepColumn);
  m_grid->addWidget(row.tolerance, index + 1, kStepColumn);
  connect(row.shown, &QCheckBox::toggled, this, [=, this](bool on) { setShown(index, on); });
  connect(row.method, &QComboBox::activated, this,
          [=, this] { setMethod(index, m_runs[index].method->currentData().toString()); });
  const FieldWords step{[index] { return tr("Step of run %1").arg(index + 1); }, stepMeaning()};
  const FieldWords tolerance{[index] { return tr("Tolerance of run %1").arg(index + 1); },
                             toleranceMeaning()};
  bindPart(row.step, index, step, &core::Solver::step);
  bindPart(row.tolerance, index, tolerance, &core::Solver::tolerance);
}

/// The reference is offered to all runs but the first, which the others are compared with.
void RunsForm::fillMethods(QComboBox* chooser, int index) {
  for (const core::Method& method : core::methods())
    chooser->addItem(methodWords(method), QString::fromUtf8(method.id.data()));
  const core::Method& reference = *core::findMethod(core::referenceSolver(1).method);
  if (index > 0) chooser->addItem(methodWords(reference), QString::fromUtf8(reference.id.data()));
  chooser->setFocusPolicy(Qt::TabFocus);
  ignoreWheelWithoutFocus(chooser);
  chooser->setAccessibleName(tr("Method of run %1").arg(index + 1));
  chooser->setAccessibleDescription(methodMeaning());
  chooser->setToolTip(methodMeaning());
}

/// The reference has neither step nor tolerance to choose.
void RunsForm::bindPart(QuantityField* field, int index, const FieldWords& words, Part part) {
  const auto read = [=, this](const core::Scene& scene) -> std::optional<double> {
    const core::Solver& solver =
        isShown(scene, index) ? scene.solvers[index] : m_runs[index].latest;
    if (core::isReference(solver)) return std::nullopt;
    return solver.*part;
  };
  bind(field, words, read,
       [=](core::Scene& scene, double value) { scene.solvers[index].*part = value; });
}

/// The mark the run's weights have in the scene, and whether it is shown.
QWidget* RunsForm::nameOf(const Row& row, int index) {
  const QString words = tr("Run %1").arg(index + 1);
  row.shown->setFocusPolicy(Qt::TabFocus);
  row.shown->setAccessibleName(words);
  row.shown->setToolTip(tr("Compute the scene with this method, too"));
  row.mark->setToolTip(words);
  auto* name = new QWidget;
  auto* layout = new QHBoxLayout(name);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(row.shown);
  QSizePolicy policy = row.shown->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  row.shown->setSizePolicy(policy);
  row.shown->setHidden(index == 0);
  layout->addWidget(row.mark);
  return name;
}

void RunsForm::setShown(int index, bool shown) {
  const auto edit = [&](core::Scene& draft) {
    if (shown) {
      draft.solvers.push_back(m_runs[index].latest);
    } else {
      draft.solvers.erase(draft.solvers.begin() + index);
    }
  };
  editor()->change(edit,
                   [shown] { return shown ? tr("addition of a run") : tr("removal of a run"); });
}

void RunsForm::setMethod(int index, const QString& id) {
  const auto edit = [&](core::Scene& draft) {
    core::Solver& solver = draft.solvers[index];
    const bool wasReference = core::isReference(solver);
    solver.method = id.toStdString();
    if (core::isReference(solver)) solver = core::referenceSolver(draft.solvers.front().step);
    if (wasReference) solver.tolerance = core::Solver().tolerance;
    // Files hold no step for those that choose their own.
    if (core::findMethod(solver.method)->isAdaptive && !core::isReference(solver))
      solver.step = core::Solver().step;
  };
  editor()->change(edit, [] { return tr("change of the method"); });
}

void RunsForm::showDraft() {
  Form::showDraft();
  for (int i = 0; i < static_cast<int>(m_runs.size()); ++i) showRun(i);
}

void RunsForm::showRun(int index) {
  Row& row = m_runs[index];
  const core::Scene& draft = editor()->draft();
  const bool shown = isShown(draft, index);
  if (shown) row.latest = draft.solvers[index];
  const QSignalBlocker quiet(row.shown);
  row.shown->setChecked(shown);
  row.shown->setEnabled(index <= static_cast<int>(draft.solvers.size()));
  row.method->setEnabled(shown);
  row.method->setCurrentIndex(row.method->findData(QString::fromStdString(row.latest.method)));
  const bool isReference = core::isReference(row.latest);
  const bool isAdaptive = core::findMethod(row.latest.method)->isAdaptive && !isReference;
  row.step->setVisible(!isAdaptive);
  row.tolerance->setVisible(isAdaptive);
  for (QuantityField* field : {row.step, row.tolerance}) field->setEnabled(shown && !isReference);
}

void RunsForm::changeEvent(QEvent* event) {
  Form::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) paintMarks();
  if (event->type() == QEvent::FontChange) sizeFields();
}

void RunsForm::sizeFields() {
  const int width = fontMetrics().horizontalAdvance(QStringLiteral("1/100000 s")) + kArrowsWidth;
  for (const Row& row : m_runs)
    for (QuantityField* field : {row.step, row.tolerance}) field->setFixedWidth(width);
}

void RunsForm::paintMarks() {
  const Theme theme = Theme::of(palette());
  for (int i = 0; i < static_cast<int>(m_runs.size()); ++i) {
    m_runs[i].mark->setPixmap(runMark(i, theme, devicePixelRatioF()));
  }
}

}  // namespace ui
