#include "ui/panels/step_panel.h"

#include <algorithm>

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>

#include "ui/chart/redraw_limiter.h"
#include "ui/control/run_controller.h"
#include "ui/control/run_words.h"
#include "ui/panels/step_table.h"
#include "ui/panels/wheel_guard.h"

namespace ui {
namespace {

constexpr int kPause = 100;  // ms: numbers that change faster cannot be read
constexpr int kLook = 50;    // ms: what looks ahead longer would keep the window waiting

/// The run's own method first, then the two the program is about.
std::vector<const core::Method*> comparedMethods(const core::Run& run) {
  std::vector<const core::Method*> methods{&run.method()};
  for (const char* id : {"euler", "rk4"})
    if (run.method().id != id) methods.push_back(core::findMethod(id));
  return methods;
}

QString timeText(double time) {
  return QLocale().toString(time, 'f', 4);
}

}  // namespace

StepPanel::StepPanel(const RunController* controller, QWidget* parent)
    : QWidget(parent),
      m_controller(controller),
      m_choosers(new QWidget),
      m_weight(new QSpinBox),
      m_run(new QComboBox),
      m_part(new QComboBox),
      m_caption(new QLabel),
      m_content(new QWidget),
      m_table(new StepTable),
      m_plot(new StepPlot),
      m_limiter(new RedrawLimiter(kPause, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_content, 1);
  auto* row = new QHBoxLayout(m_content);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(m_table, 2);
  row->addWidget(m_plot, 1);
  buildChoosers();
  connect(controller, &RunController::restarted, this, &StepPanel::listRuns);
  connect(controller, &RunController::timeShown, m_limiter, &RedrawLimiter::request);
  connect(controller, &RunController::playingChanged, m_limiter, &RedrawLimiter::hurry);
  connect(m_limiter, &RedrawLimiter::due, this, &StepPanel::openStep);
}

void StepPanel::buildChoosers() {
  auto* layout = new QHBoxLayout(m_choosers);
  layout->setContentsMargins(0, 0, 0, 0);
  m_choosers->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  layout->addWidget(new QLabel(tr("of weight")));
  layout->addWidget(m_weight);
  layout->addWidget(m_run);
  layout->addWidget(m_part);
  layout->addWidget(m_caption, 1);
  m_caption->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_weight->setFocusPolicy(Qt::StrongFocus);
  ignoreWheelWithoutFocus(m_weight);
  m_weight->setAccessibleName(tr("Weight whose step is shown"));
  m_weight->setToolTip(tr("Which weight, counted from the left"));
  m_run->setFocusPolicy(Qt::TabFocus);
  m_run->setAccessibleName(tr("Run whose step is shown"));
  m_run->setToolTip(m_run->accessibleName());
  m_run->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_part->setFocusPolicy(Qt::TabFocus);
  m_part->setAccessibleName(tr("Part of the step"));
  m_part->setToolTip(tr("Events divide a step: the method starts anew after each"));
  m_part->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  connect(m_weight, &QSpinBox::valueChanged, this, &StepPanel::openStep);
  connect(m_weight, &QSpinBox::valueChanged, this, &StepPanel::weightChosen);
  connect(m_run, &QComboBox::currentIndexChanged, this, &StepPanel::openStep);
  connect(m_part, &QComboBox::currentIndexChanged, this, &StepPanel::showPart);
}

void StepPanel::chooseWeight(int number) {
  if (number > 0) m_weight->setValue(number);
}

int StepPanel::chosenRun() const {
  return m_run->currentIndex();
}

void StepPanel::setSeen(bool seen) {
  m_isSeen = seen;
  if (seen) {
    m_limiter->hurry();
  } else {
    emit stepOpened(nullptr, 0);
  }
}

void StepPanel::listRuns() {
  {
    const QSignalBlocker quietRun(m_run), quietWeight(m_weight);
    const int chosen = m_run->currentIndex();
    m_run->clear();
    for (int i = 0; i < m_controller->runCount(); ++i)
      m_run->addItem(runWords(m_controller->run(i).solver()));
    m_run->setCurrentIndex(std::clamp(chosen, 0, m_controller->runCount() - 1));
    const int count = m_controller->run(0).weightCount();
    m_weight->setRange(std::min(1, count), count);
  }
  m_run->setVisible(m_controller->runCount() > 1);
  m_limiter->hurry();
}

void StepPanel::openStep() {
  if (!isVisible() || !m_isSeen || m_run->currentIndex() < 0) return;
  const core::Run& run = m_controller->run(chosenRun());
  m_parts.clear();
  if (m_weight->value() > 0) {
    m_parts = run.latestStep(m_weight->value() - 1);
    m_isComing = m_parts.empty();
    if (m_isComing && !lookAhead(run))
      return showNothing(tr("The coming step takes long to compute: go on to see it."));
  }
  listParts();
  showPart();
}

/// @return  false where the coming step takes too long to be shown ahead
bool StepPanel::lookAhead(const core::Run& run) {
  QElapsedTimer clock;
  clock.start();
  bool isQuick = true;
  m_parts = run.nextStep(m_weight->value() - 1,
                         [&](double) { return isQuick = clock.elapsed() < kLook; });
  return isQuick;
}

void StepPanel::listParts() {
  const QSignalBlocker quiet(m_part);
  m_part->clear();
  const int count = static_cast<int>(m_parts.size());
  for (int i = 0; i < count; ++i) m_part->addItem(tr("Part %1 of %2").arg(i + 1).arg(count));
  m_part->setCurrentIndex(partUnderWay());
  m_part->setVisible(count > 1);
}

/// The one the moment shown lies in.
int StepPanel::partUnderWay() const {
  const auto found = std::ranges::find_if(
      m_parts, [this](const core::StepPart& part) { return m_controller->time() <= part.end; });
  const auto place = static_cast<int>(found - m_parts.begin());
  return std::min(place, static_cast<int>(m_parts.size()) - 1);
}

void StepPanel::showPart() {
  if (m_parts.empty()) return showNothing(tr("There is no step to show."));
  const core::StepPart& part =
      m_parts[static_cast<std::size_t>(std::max(0, m_part->currentIndex()))];
  const core::Run& run = m_controller->run(chosenRun());
  if (!run.method().isOffered)
    return showNothing(tr("The reference takes no slopes: choose another run."));
  if (part.stages.empty()) return showNothing(tr("Nothing moves the weight in this step."));
  const int weight = m_weight->value() - 1;
  const core::ExactWay exact = core::exactWay(run, weight, part);
  const std::vector<core::StepEnd> ends =
      core::stepEnds(run, weight, part, exact, comparedMethods(run));
  m_content->show();
  m_caption->setText(caption(part));
  m_table->showPart(part, run.method(), exact, ends);
  m_plot->showStep(plotted(part, exact, ends));
  const ShownStep step = shown(part);
  // While it plays the arrows would flicker beside the weight.
  emit stepOpened(m_controller->isPlaying() ? nullptr : &step,
                  static_cast<std::size_t>(chosenRun()));
}

void StepPanel::showNothing(const QString& reason) {
  m_content->hide();
  m_caption->setText(reason);
  emit stepOpened(nullptr, 0);
}

QString StepPanel::caption(const core::StepPart& part) const {
  const QString words = m_isComing ? tr("to come, from %1 s to %2 s") : tr("from %1 s to %2 s");
  return words.arg(timeText(part.begin), timeText(part.end));
}

PlottedStep StepPanel::plotted(const core::StepPart& part, const core::ExactWay& exact,
                               const std::vector<core::StepEnd>& ends) const {
  const StateQuantity quantity = plottedQuantity(part.mode);
  const auto value = [&](const core::Entries& entries) {
    return entries[quantity.entry] / quantity.size;
  };
  PlottedStep step;
  step.quantity = quantity.symbol;
  step.unit = quantity.unit;
  step.start = {part.begin, value(part.beginState)};
  step.duration = part.duration();
  for (std::size_t i = 0; i < exact.times.size(); ++i)
    step.exact.append({exact.times[i], value(exact.states[i])});
  for (std::size_t i = 0; i < part.stages.size(); ++i) {
    const core::Stage& stage = part.stages[i];
    const double time = part.begin + stage.node * part.duration();
    step.slopes.push_back({stageName(i), {time, value(stage.state)}, value(stage.slope)});
  }
  for (const core::StepEnd& end : ends)
    step.ends.push_back({methodWords(*end.method), {part.end, value(end.state)}});
  return step;
}

ShownStep StepPanel::shown(const core::StepPart& part) const {
  ShownStep step;
  step.start = part.beginPosition;
  step.end = part.endPosition;
  step.anchor = m_isComing ? part.beginPosition : part.endPosition;
  for (std::size_t i = 0; i < part.stages.size(); ++i) {
    const core::Stage& stage = part.stages[i];
    step.slopes.push_back({stageName(i), stage.position, part.duration() * stage.velocity});
  }
  return step;
}

void StepPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  m_limiter->hurry();
}

void StepPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  emit stepOpened(nullptr, 0);
}

}  // namespace ui
