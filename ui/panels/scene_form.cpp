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
      {[] { return tr("Weights"); }, tr("How many weights there are, hung up at even intervals. "
                                        "New ones are like the last one.")},
      {.range = kCountRange, .arrowStep = 1, .wholeNumbers = true},
      [](const core::Scene& scene) { return static_cast<double>(scene.weights.size()); },
      [](core::Scene& scene, double count) {
        scene = core::withWeightCount(scene, static_cast<int>(count));
      });
  addCut();
}

void SceneForm::addSurroundings() {
  addQuantity(
      {[] { return tr("Gravity"); }, tr("Acceleration of free fall g, in m/s². It pulls each "
                                        "weight down with the force m g. On Earth 9.81 m/s².")},
      {core::kGravityRange, 0.1}, [](const core::Scene& scene) { return scene.gravity; },
      [](core::Scene& scene, double gravity) { scene.gravity = gravity; });
  addQuantity(
      {[] { return tr("Air density"); },
       tr("Density of the air ρ, in kg/m³. Drag is F = ½ ρ c_d A v² against the velocity, with A = "
          "π r². 1.2 kg/m³ at sea level, 0 for vacuum.")},
      {core::kAirDensityRange, 0.1}, [](const core::Scene& scene) { return scene.airDensity; },
      [](core::Scene& scene, double density) { scene.airDensity = density; });
}

void SceneForm::addRoom() {
  addHeading(tr("Room"));
  addQuantity(
      {[] { return tr("Width"); }, tr("Distance between the walls, in m.")},
      {core::kRoomSizeRange, 0.1}, [](const core::Scene& scene) { return scene.room.width; },
      [](core::Scene& scene, double width) { scene.room.width = width; });
  addQuantity(
      {[] { return tr("Height"); }, tr("Distance between floor and ceiling, in m.")},
      {core::kRoomSizeRange, 0.1}, [](const core::Scene& scene) { return scene.room.height; },
      [](core::Scene& scene, double height) { scene.room.height = height; });
}

void SceneForm::addImpacts() {
  addHeading(tr("Impacts"));
  addQuantity(
      {[] { return tr("Restitution of walls"); },
       tr("Share e of the speed towards a wall, the floor or the ceiling with which a weight "
          "leaves it: 1 loses nothing, 0 does not bounce.")},
      {core::kRestitutionRange, 0.05},
      [](const core::Scene& scene) { return scene.room.restitution; },
      [](core::Scene& scene, double restitution) { scene.room.restitution = restitution; });
  addQuantity(
      {[] { return tr("Friction of walls"); },
       tr("Friction coefficient μ of walls, floor and ceiling. Friction is at most μ times the "
          "force, or the impulse, that presses the weight against them.")},
      {core::kFrictionRange, 0.05}, [](const core::Scene& scene) { return scene.room.friction; },
      [](core::Scene& scene, double friction) { scene.room.friction = friction; });
  addQuantity(
      {[] { return tr("Restitution of weights"); },
       tr("Share e of the speed towards each other with which two weights part after an impact: 1 "
          "loses nothing, 0 does not bounce.")},
      {core::kRestitutionRange, 0.05}, [](const core::Scene& scene) { return scene.restitution; },
      [](core::Scene& scene, double restitution) { scene.restitution = restitution; });
}

void SceneForm::addCut() {
  m_cutByClock->setToolTip(tr("Unticked: all ropes are cut by hand, with the Cut button"));
  m_cutByClock->setFocusPolicy(Qt::TabFocus);
  m_cutTime->spinBox()->setEmptyWords(tr("by hand"));
  rows()->addRow(m_cutByClock, m_cutTime);
  const FieldWords words{[] { return tr("Time of the cut"); },
                         tr("Simulated time in s at which all ropes are cut.")};
  bind(
      m_cutTime, words, [](const core::Scene& scene) { return scene.cutTime; },
      [](core::Scene& scene, double time) { scene.cutTime = time; });
  connect(m_cutByClock, &QCheckBox::toggled, this, &SceneForm::setCutByClock);
}

void SceneForm::setCutByClock(bool byClock) {
  editor()->change(
      [byClock](core::Scene& draft) {
        draft.cutTime = byClock ? std::optional(kFirstCutTime) : std::nullopt;
      },
      [] { return tr("change of the cut"); });
}

void SceneForm::showDraft() {
  Form::showDraft();
  const bool byClock = editor()->draft().cutTime.has_value();
  const QSignalBlocker quiet(m_cutByClock);
  m_cutByClock->setChecked(byClock);
  m_cutTime->setEnabled(byClock);
}

}  // namespace ui
