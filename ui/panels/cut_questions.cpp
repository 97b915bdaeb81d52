#include "ui/panels/cut_questions.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include "core/scene/scene_limits.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_target.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/task_row.h"
#include "ui/panels/wheel_guard.h"

namespace ui {
namespace {

constexpr core::Range kCutRange{0, 1000, "s"};
constexpr core::Range kPlaceRange{0, 1e5, "m"};
constexpr core::Range kWidthRange{1e-4, 1e5, "m"};

/// Enough for a fall from the ceiling, and back up there and down again.
double longestWait(const core::Scene& scene) {
  constexpr double kLeast = 10, kFalls = 4;
  if (scene.gravity <= 0) return kLeast;
  return std::max(kLeast, kFalls * std::sqrt(2 * scene.room.height / scene.gravity));
}

}  // namespace

CutQuestions::CutQuestions(const SceneEditor* editor, SceneTarget* target, TaskRow* row,
                           QWidget* parent)
    : QWidget(parent),
      m_editor(editor),
      m_target(target),
      m_weight(new QSpinBox),
      m_run(new QComboBox),
      m_center(new QuantityField({.range = kPlaceRange, .arrowStep = 0.1})),
      m_width(new QuantityField({.range = kWidthRange, .arrowStep = 0.05})),
      m_from(new QuantityField({.range = kCutRange, .arrowStep = 1})),
      m_until(new QuantityField({.range = kCutRange, .arrowStep = 1})) {
  buildFields();
  layOut();
  row->add(tr("Cut between"), m_from);
  row->add(tr("and"), m_until);
  listRuns();
  showTarget();
}

void CutQuestions::buildFields() {
  m_weight->setAccessibleName(tr("Weight that is to hit the target"));
  m_weight->setToolTip(tr("Which weight, counted from the left"));
  m_weight->setFocusPolicy(Qt::StrongFocus);
  ignoreWheelWithoutFocus(m_weight);
  m_run->setAccessibleName(tr("Method that finds the moments"));
  m_run->setToolTip(m_run->accessibleName());
  m_run->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_center->setName(tr("Center of the target"),
                    tr("Where the middle of the target lies, x in m from the left wall"));
  m_width->setName(tr("Width of the target"), tr("How wide the target is, in m"));
  m_from->setName(tr("First cut time"), tr("The earliest moment to cut, in s"));
  m_until->setName(tr("Last cut time"), tr("The latest moment to cut, in s"));
  m_from->setValue(m_firstCut);
  m_until->setValue(m_lastCut);

  connect(m_weight, &QSpinBox::valueChanged, this,
          [this](int number) { m_target->setWeight(number - 1); });
  connect(m_run, &QComboBox::activated, this, &CutQuestions::runChosen);
  connect(m_center, &QuantityField::edited, this, [this](double center) {
    m_target->setPlace({center, m_target->place().width});
  });
  connect(m_width, &QuantityField::edited, this, [this](double width) {
    m_target->setPlace({m_target->place().center, width});
  });
  connect(m_from, &QuantityField::edited, this, [this](double time) {
    m_firstCut = time;
    emit timesChanged();
  });
  connect(m_until, &QuantityField::edited, this, [this](double time) {
    m_lastCut = time;
    emit timesChanged();
  });
}

void CutQuestions::layOut() {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 8, 12, 0);
  layout->setSpacing(10);
  layout->addWidget(new QLabel(tr("Weight")));
  layout->addWidget(m_weight);
  layout->addWidget(new QLabel(tr("by")));
  layout->addWidget(m_run);
  layout->addSpacing(20);
  layout->addWidget(new QLabel(tr("Target at")));
  layout->addWidget(m_center);
  layout->addWidget(new QLabel(tr("Width")));
  layout->addWidget(m_width);
  layout->addStretch(1);
}

core::CutSweepQuestion CutQuestions::question() const {
  return {.weight = m_target->weight(),
          .from = m_firstCut,
          .until = m_lastCut,
          .longestWait = longestWait(*m_editor->scene())};
}

std::size_t CutQuestions::run() const {
  return static_cast<std::size_t>(std::max(0, m_run->currentIndex()));
}

bool CutQuestions::checkTimes() {
  if (m_lastCut <= m_firstCut) {
    m_until->mark(tr("must be later than the first"));
    return false;
  }
  m_until->clearMark();
  return true;
}

void CutQuestions::listRuns() {
  const int chosen = std::max(0, m_run->currentIndex());
  const auto& solvers = m_editor->scene()->solvers;
  m_run->clear();
  for (const core::Solver& solver : solvers) m_run->addItem(runWords(solver));
  m_run->setCurrentIndex(chosen < m_run->count() ? chosen : 0);
  const QSignalBlocker quiet(m_weight);
  m_weight->setRange(1, std::max(1, static_cast<int>(m_editor->scene()->weights.size())));
}

void CutQuestions::showTarget() {
  {
    const QSignalBlocker quiet(m_weight);
    m_weight->setValue(m_target->weight() + 1);
  }
  m_center->setValue(m_target->place().center);
  m_width->setValue(m_target->place().width);
}

}  // namespace ui
