#pragma once

#include <cstddef>

#include <QWidget>

#include "core/aim/cut_sweep.h"

class QComboBox;
class QSpinBox;

namespace ui {

class QuantityField;
class SceneEditor;
class SceneTarget;
class TaskRow;

/// What is asked of a sweep of cut times: which weight is to hit which target, by which method,
/// and between which times the ropes may be cut.
class CutQuestions : public QWidget {
  Q_OBJECT

 public:
  /// @param row  the cut times are asked for in it, before its button
  CutQuestions(const SceneEditor* editor, SceneTarget* target, TaskRow* row,
               QWidget* parent = nullptr);

  core::CutSweepQuestion question() const;
  /// Index of the run whose method finds the moments.
  std::size_t run() const;
  /// Whether the cut times make sense; marks them where they do not.
  bool checkTimes();

  /// Offers the runs and weights of the scene.
  void listRuns();
  void showTarget();

 signals:
  void runChosen();
  void timesChanged();

 private:
  void buildFields();
  void layOut();

  const SceneEditor* m_editor;
  SceneTarget* m_target;
  QSpinBox* m_weight;
  QComboBox* m_run;
  QuantityField* m_center;
  QuantityField* m_width;
  QuantityField* m_from;
  QuantityField* m_until;
  double m_firstCut = 0;  // [s]
  double m_lastCut = 10;  // [s]
};

}  // namespace ui
