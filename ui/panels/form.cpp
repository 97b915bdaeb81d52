#include "ui/panels/form.h"

#include <QFormLayout>
#include <QLabel>

#include "ui/control/problem_words.h"
#include "ui/control/scene_editor.h"
#include "ui/control/translations.h"
#include "ui/panels/quantity_field.h"

namespace ui {

Form::Form(SceneEditor* editor, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_rows(new QFormLayout(this)) {
  m_rows->setContentsMargins(12, 8, 12, 8);
  m_rows->setHorizontalSpacing(12);
  m_rows->setVerticalSpacing(6);
  m_rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  connect(editor, &SceneEditor::sceneReplaced, this, &Form::discardTyped);
  connect(editor, &SceneEditor::draftChanged, this, [this] { showDraft(); });
}

void Form::addHeading(const QString& words) {
  auto* heading = new QLabel(words);
  QFont bold = heading->font();
  bold.setBold(true);
  heading->setFont(bold);
  if (m_rows->rowCount() > 0) heading->setContentsMargins(0, 8, 0, 0);
  m_rows->addRow(heading);
}

QuantityField* Form::addQuantity(const FieldWords& words, const QuantityStyle& style, Reader read,
                                 Writer write) {
  auto* field = new QuantityField(style);
  m_rows->addRow(words.name.text(), field);
  m_rows->labelForField(field)->setToolTip(words.meaning);
  bind(field, words, std::move(read), std::move(write));
  return field;
}

void Form::bind(QuantityField* field, const FieldWords& words, Reader read, Writer write) {
  field->setName(words.name.text(), words.meaning);
  m_bindings.push_back({field, std::move(read)});
  const auto changeOf = [name = words.name] {
    return tr("change of %1").arg(withinSentence(name.text()));
  };
  connect(field, &QuantityField::edited, this,
          [this, field, changeOf, write = std::move(write)](double value) {
            const QuantitySpinBox* box = field->spinBox();
            // One go of an arrow is one step; what is typed is a step each time.
            const QString mergeKey = box->isStepping() ? box->accessibleName() : QString();
            const bool canRun = m_editor->change([&](core::Scene& draft) { write(draft, value); },
                                                 changeOf, mergeKey);
            if (!canRun) field->mark(problemWords(m_editor->problems().front()));
          });
  connect(field->spinBox(), &QAbstractSpinBox::editingFinished, m_editor, &SceneEditor::closeStep);
  connect(field, &QuantityField::cancelled, m_editor, &SceneEditor::giveUpDraft);
}

void Form::showDraft() {
  for (const Binding& binding : m_bindings) {
    const std::optional<double> value = binding.read(m_editor->draft());
    if (value) {
      binding.field->setValue(*value);
    } else {
      binding.field->setNoValue();
    }
  }
}

void Form::discardTyped() {
  for (const Binding& binding : m_bindings) binding.field->discard();
}

}  // namespace ui
