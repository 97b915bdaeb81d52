#pragma once

#include "ui/panels/form.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace ui {

/// Which methods run side by side, and with what steps or tolerances. The first run is always
/// there; up to three others can be switched on, the reference among them.
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
    QuantityField* tolerance = nullptr;  // in the place of the step, for adaptive methods
    core::Solver latest;                 // comes back when the run is switched on again
  };

  using Part = double core::Solver::*;

  static QString methodMeaning();
  static QString stepMeaning();
  static QString toleranceMeaning();
  void addHeadings();
  void addRun(int index);
  void fillMethods(QComboBox* chooser, int index);
  void bindPart(QuantityField* field, int index, const FieldWords& words, Part part);
  QWidget* nameOf(const Row& row, int index);
  void showRun(int index);
  void setShown(int index, bool shown);
  void setMethod(int index, const QString& id);
  void sizeFields();
  void paintMarks();

  QGridLayout* m_grid;
  std::vector<Row> m_runs;
};

}  // namespace ui
