#include "ui/panels/weights_form.h"

#include <algorithm>
#include <span>

#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

#include "core/scene/scene_limits.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/weight_columns.h"
#include "ui/panels/wheel_guard.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

/// The chosen weights: one, or all for number 0.
template <class Scene>
auto chosenOf(Scene& scene, int number) {
  std::span weights(scene.weights);
  return number == 0 ? weights : weights.subspan(static_cast<std::size_t>(number - 1), 1);
}

double* ropePart(core::Weight& weight, double core::Rope::*part) {
  return weight.rope ? &((*weight.rope).*part) : nullptr;
}

}  // namespace

WeightsForm::WeightsForm(SceneEditor* editor, QWidget* parent)
    : Form(editor, parent), m_chooser(new QSpinBox) {
  addChooser();
  addRopeRows();
  addBodyRows();
  addTableButton();
  WeightsForm::showDraft();
}

void WeightsForm::choose(int number) {
  m_chooser->setValue(number);
}

void WeightsForm::addChooser() {
  m_chooser->setSpecialValueText(tr("All"));
  m_chooser->setAlignment(Qt::AlignRight);
  m_chooser->setFocusPolicy(Qt::StrongFocus);
  ignoreWheelWithoutFocus(m_chooser);
  m_chooser->setAccessibleName(tr("Weight"));
  m_chooser->setToolTip(tr("Which weight the fields below belong to, counted from the left"));
  rows()->addRow(tr("Weight"), m_chooser);
  connect(m_chooser, &QSpinBox::valueChanged, this, [this] { showDraft(); });
  connect(m_chooser, &QSpinBox::valueChanged, this, [this] { this->editor()->closeStep(); });
  connect(m_chooser, &QSpinBox::valueChanged, this, &WeightsForm::weightChosen);
}

void WeightsForm::addRopeRows() {
  addHeading(tr("Rope"));
  m_ropeLength =
      addWeightQuantity({[] { return tr("Length"); }, columnMeaning(WeightColumn::kLength)},
                        {core::kRopeLengthRange, 0.05},
                        [](core::Weight& weight) { return ropePart(weight, &core::Rope::length); });
  m_ropeAngle =
      addWeightQuantity({[] { return tr("Start angle"); }, columnMeaning(WeightColumn::kAngle)},
                        {core::kRopeAngleRange, 5},
                        [](core::Weight& weight) { return ropePart(weight, &core::Rope::angle); });
}

void WeightsForm::addBodyRows() {
  addHeading(tr("Body"));
  m_bodyFields = {
      addWeightQuantity({[] { return tr("Mass"); }, columnMeaning(WeightColumn::kMass)},
                        {core::kMassRange, 0.01},
                        [](core::Weight& weight) { return &weight.mass; }),
      addWeightQuantity({[] { return tr("Radius"); }, columnMeaning(WeightColumn::kRadius)},
                        {core::kRadiusRange, 0.005},
                        [](core::Weight& weight) { return &weight.radius; }),
      addWeightQuantity(
          {[] { return tr("Drag coefficient"); }, columnMeaning(WeightColumn::kDragCoefficient)},
          {core::kDragCoefficientRange, 0.05},
          [](core::Weight& weight) { return &weight.dragCoefficient; }),
  };
}

void WeightsForm::addTableButton() {
  auto* button = new QPushButton(icon("table"), tr("All weights in a table…"));
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(tr("Change many weights at once, and copy them from and to spreadsheets"));
  connect(button, &QPushButton::clicked, this, &WeightsForm::tableWanted);
  rows()->addRow(button);
}

/// @param part  where a weight keeps the quantity; null where it has none
QuantityField* WeightsForm::addWeightQuantity(const FieldWords& words, const QuantityStyle& style,
                                              const std::function<double*(core::Weight&)>& part) {
  const auto read = [this, part](const core::Scene& scene) -> std::optional<double> {
    std::optional<double> common;
    for (core::Weight weight : chosenOf(scene, m_chooser->value())) {
      const double* value = part(weight);
      if (!value) continue;
      if (common && *common != *value) return std::nullopt;
      common = *value;
    }
    return common;
  };
  const auto write = [this, part](core::Scene& scene, double value) {
    for (core::Weight& weight : chosenOf(scene, m_chooser->value())) {
      if (double* place = part(weight)) *place = value;
    }
  };
  return addQuantity(words, style, read, write);
}

void WeightsForm::showDraft() {
  const core::Scene& draft = editor()->draft();
  {
    const QSignalBlocker quiet(m_chooser);
    m_chooser->setRange(0, static_cast<int>(draft.weights.size()));
  }
  Form::showDraft();
  const auto chosen = chosenOf(draft, m_chooser->value());
  const bool anyHangs = std::any_of(chosen.begin(), chosen.end(),
                                    [](const core::Weight& weight) { return !!weight.rope; });
  m_ropeLength->setEnabled(anyHangs);
  m_ropeAngle->setEnabled(anyHangs);
  for (QuantityField* field : m_bodyFields) field->setEnabled(!chosen.empty());
}

}  // namespace ui
