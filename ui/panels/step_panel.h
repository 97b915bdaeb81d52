#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/run/step_stages.h"
#include "core/trade/step_ends.h"
#include "ui/chart/step_plot.h"
#include "ui/view/shown_step.h"

class QComboBox;
class QLabel;
class QSpinBox;

namespace ui {

class RedrawLimiter;
class RunController;
class StepTable;

/// Opens up one step of one weight: its slopes in numbers and as arrows, and where it ends
/// beside other methods and the exact way. Shows the step that led to the moment shown; at
/// the start the one to come.
class StepPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StepPanel(const RunController* controller, QWidget* parent = nullptr);

  /// Chooses weight, run and part of the step, wherever it is laid out.
  QWidget* choosers() const { return m_choosers; }

  /// @param number  counted from 1; 0, all weights, keeps the one chosen
  void chooseWeight(int number);
  int chosenRun() const;
  /// Whether the panel lies open to the user: one behind another tab only seems visible.
  void setSeen(bool seen);

 signals:
  /// The user chose another weight, counted from 1.
  void weightChosen(int number);
  /// What to draw in the scene from now on; null: nothing.
  void stepOpened(const ShownStep* step, std::size_t run);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void buildChoosers();
  void listRuns();
  void openStep();
  void listParts();
  int partUnderWay() const;
  void showPart();
  bool lookAhead(const core::Run& run);
  void showNothing(const QString& reason);
  PlottedStep plotted(const core::StepPart& part, const core::ExactWay& exact,
                      const std::vector<core::StepEnd>& ends) const;
  ShownStep shown(const core::StepPart& part) const;
  QString caption(const core::StepPart& part) const;

  const RunController* m_controller;
  QWidget* m_choosers;
  QSpinBox* m_weight;
  QComboBox* m_run;
  QComboBox* m_part;
  QLabel* m_caption;
  QWidget* m_content;
  StepTable* m_table;
  StepPlot* m_plot;
  RedrawLimiter* m_limiter;
  std::vector<core::StepPart> m_parts;
  bool m_isSeen = true;
  bool m_isComing = false;  // the parts are of the step to come
};

}  // namespace ui
