#pragma once

#include "ui/panels/form.h"

class QSpinBox;

namespace ui {

/// Rope, size and drag of one weight, or of all weights at once.
class WeightsForm : public Form {
  Q_OBJECT

 public:
  explicit WeightsForm(SceneEditor* editor, QWidget* parent = nullptr);

  /// Shows this weight, counted from 1; 0: all.
  void choose(int number);

 signals:
  /// All weights are to be shown at once.
  void tableWanted();
  /// Another weight is shown, counted from 1; 0: all.
  void weightChosen(int number);

 protected:
  void showDraft() override;

 private:
  void addChooser();
  void addRopeRows();
  void addBodyRows();
  void addTableButton();
  QuantityField* addWeightQuantity(const FieldWords& words, const QuantityStyle& style,
                                   const std::function<double*(core::Weight&)>& part);

  QSpinBox* m_chooser;
  QuantityField* m_ropeLength;
  QuantityField* m_ropeAngle;
  std::vector<QuantityField*> m_bodyFields;
};

}  // namespace ui
