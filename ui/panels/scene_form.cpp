#include "ui/panels/scene_form.h"

#include <QCheckBox>
#include <QFormLayout>

#include "core/scene/arrangement.h"
#include "core/scene/scene_limits.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/quantity_field.h"

namespace ui {
namespace {

constexpr double kFirstCutTime = 1;  // s: offered when the clock is to cut
constexpr core::Range kCountRange{0, core::kMostWeights, ""};

}  // namespace

SceneForm::SceneForm(SceneEditor* editor, QWidget* parent)
    : Form(editor, parent),
      m_cutByClock(new QCheckBox(tr("Cut at"))),
      m_cutTime(new QuantityField({core::kCutTimeRange, 0.1})) {
  addWeights();
  addSurroundings();
  addRoom();
  addImpacts();
  SceneForm::showDraft();
}

void SceneForm::addWeights() {
  addQuantity(
      tr("Weights"), {.range = kCountRange, .arrowStep = 1, .wholeNumbers = true},
      [](const core::Scene& scene) { return static_cast<double>(scene.weights.size()); },
      [](core::Scene& scene, double count) {
        scene = core::withWeightCount(scene, static_cast<int>(count));
      });
  addCut();
}

void SceneForm::addSurroundings() {
  addQuantity(
      tr("Gravity"), {core::kGravityRange, 0.1},
      [](const core::Scene& scene) { return scene.gravity; },
      [](core::Scene& scene, double gravity) { scene.gravity = gravity; });
  addQuantity(
      tr("Air density"), {core::kAirDensityRange, 0.1},
      [](const core::Scene& scene) { return scene.airDensity; },
      [](core::Scene& scene, double density) { scene.airDensity = density; });
}

void SceneForm::addRoom() {
  addHeading(tr("Room"));
  addQuantity(
      tr("Width"), {core::kRoomSizeRange, 0.1},
      [](const core::Scene& scene) { return scene.room.width; },
      [](core::Scene& scene, double width) { scene.room.width = width; });
  addQuantity(
      tr("Height"), {core::kRoomSizeRange, 0.1},
      [](const core::Scene& scene) { return scene.room.height; },
      [](core::Scene& scene, double height) { scene.room.height = height; });
}

void SceneForm::addImpacts() {
  addHeading(tr("Impacts"));
  addQuantity(
      tr("Restitution of walls"), {core::kRestitutionRange, 0.05},
      [](const core::Scene& scene) { return scene.room.restitution; },
      [](core::Scene& scene, double restitution) { scene.room.restitution = restitution; });
  addQuantity(
      tr("Friction of walls"), {core::kFrictionRange, 0.05},
      [](const core::Scene& scene) { return scene.room.friction; },
      [](core::Scene& scene, double friction) { scene.room.friction = friction; });
  addQuantity(
      tr("Restitution of weights"), {core::kRestitutionRange, 0.05},
      [](const core::Scene& scene) { return scene.restitution; },
      [](core::Scene& scene, double restitution) { scene.restitution = restitution; });
}

void SceneForm::addCut() {
  m_cutByClock->setToolTip(tr("Unticked: all ropes are cut by hand, with the Cut button"));
  m_cutByClock->setFocusPolicy(Qt::TabFocus);
  m_cutTime->spinBox()->setAccessibleName(tr("Time of the cut"));
  m_cutTime->spinBox()->setEmptyWords(tr("by hand"));
  rows()->addRow(m_cutByClock, m_cutTime);
  bind(
      m_cutTime, [](const core::Scene& scene) { return scene.cutTime; },
      [](core::Scene& scene, double time) { scene.cutTime = time; });
  connect(m_cutByClock, &QCheckBox::toggled, this, &SceneForm::setCutByClock);
}

void SceneForm::setCutByClock(bool byClock) {
  editor()->change(
      [byClock](core::Scene& draft) {
        draft.cutTime = byClock ? std::optional(kFirstCutTime) : std::nullopt;
      },
      tr("change of the cut"));
}

void SceneForm::showDraft() {
  Form::showDraft();
  const bool byClock = editor()->draft().cutTime.has_value();
  const QSignalBlocker quiet(m_cutByClock);
  m_cutByClock->setChecked(byClock);
  m_cutTime->setEnabled(byClock);
}

}  // namespace ui
