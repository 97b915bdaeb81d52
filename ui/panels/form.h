#pragma once

#include <functional>
#include <vector>

#include <QString>
#include <QWidget>

#include "core/scene/scene.h"
#include "ui/control/words.h"
#include "ui/panels/quantity_spin_box.h"

class QFormLayout;

namespace ui {

class QuantityField;
class SceneEditor;

/// What a field is called, and what its number means.
struct FieldWords {
  Words name;       ///< as a label: "Air density"
  QString meaning;  ///< in a sentence or two, with symbol and formula
};

/// A column of fields that show a scene's draft and change it.
class Form : public QWidget {
  Q_OBJECT

 public:
  explicit Form(SceneEditor* editor, QWidget* parent = nullptr);

 protected:
  /// Reads a field's value from the draft; nothing where there are several, or none.
  using Reader = std::function<std::optional<double>(const core::Scene&)>;
  /// Writes a field's value into the draft.
  using Writer = std::function<void(core::Scene&, double)>;

  SceneEditor* editor() const { return m_editor; }
  QFormLayout* rows() const { return m_rows; }

  /// Adds a heading above the rows that follow.
  void addHeading(const QString& words);
  /// Adds a row with a field that shows and changes one quantity of the draft.
  QuantityField* addQuantity(const FieldWords& words, const QuantityStyle& style, Reader read,
                             Writer write);
  /// Lets a field that is laid out elsewhere show and change one quantity of the draft.
  void bind(QuantityField* field, const FieldWords& words, Reader read, Writer write);

  /// Shows the draft; called whenever it has changed.
  virtual void showDraft();

 private:
  struct Binding {
    QuantityField* field;
    Reader read;
  };

  void discardTyped();

  SceneEditor* m_editor;
  QFormLayout* m_rows;
  std::vector<Binding> m_bindings;
};

}  // namespace ui
