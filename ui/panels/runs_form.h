#pragma once

#include "ui/panels/form.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace ui {

/// Which methods run side by side, and with what steps or tolerances. The first run is always
/// there; the others can be switched off.
class RunsForm : public Form {
  Q_OBJECT

 public:
  explicit RunsForm(SceneEditor* editor, QWidget* parent = nullptr);

 protected:
  void showDraft() override;
  void changeEvent(QEvent* event) override;

 private:
  struct Row {
    QCheckBox* shown = nullptr;  // hidden for the first run
    QLabel* mark = nullptr;
    QComboBox* method = nullptr;
    QuantityField* step = nullptr;
    QuantityField* tolerance = nullptr;  // in place of the step for adaptive methods
    core::Solver latest;                 // comes back when the run is switched on again
  };

  void addRun(int index);
  void bindNumber(QuantityField* field, int index, double core::Solver::*number);
  QWidget* nameOf(const Row& row, int index);
  void showRun(int index);
  void setShown(int index, bool shown);
  void setMethod(int index, const QString& id);
  void paintMarks();

  std::vector<Row> m_runs;
};

}  // namespace ui
