#pragma once

#include "ui/panels/form.h"

class QCheckBox;

namespace ui {

/// What all weights share: how many there are, gravity, air, room, impacts and the cut.
class SceneForm : public Form {
  Q_OBJECT

 public:
  explicit SceneForm(SceneEditor* editor, QWidget* parent = nullptr);

 protected:
  void showDraft() override;

 private:
  void addWeights();
  void addCut();
  void addSurroundings();
  void addRoom();
  void addImpacts();
  void setCutByClock(bool byClock);

  QCheckBox* m_cutByClock;
  QuantityField* m_cutTime;
};

}  // namespace ui
