#pragma once

#include <QDialog>

#include "core/scene/scene.h"

class QLabel;

namespace ui {

class AccuracyPanel;
class SceneEditor;
class StabilityPanel;

/// What accuracy costs and how large steps may be, beside the main window, which stays usable.
class TradeWindow : public QDialog {
  Q_OBJECT

 public:
  explicit TradeWindow(SceneEditor* editor, QWidget* parent = nullptr);

  AccuracyPanel* accuracy() const { return m_accuracy; }
  StabilityPanel* stability() const { return m_stability; }

  /// Shows the window, in front of others.
  void bringUp();

 private:
  void openAsRun(const core::Solver& solver);

  SceneEditor* m_editor;
  AccuracyPanel* m_accuracy;
  StabilityPanel* m_stability;
  QLabel* m_opened;
};

}  // namespace ui
