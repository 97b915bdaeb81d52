#pragma once

#include <memory>
#include <vector>

#include <QDialog>
#include <QString>

#include "core/aim/cut_sweep.h"
#include "ui/chart/cut_sweep_result.h"

class QComboBox;
class QLabel;
class QSpinBox;
class QTimer;
class QToolButton;

namespace ui {

class BackgroundTask;
class CutSweepChart;
class HitTable;
class QuantityField;
class SceneEditor;
class SceneTarget;
class TaskRow;

/// When to cut? Landing place of a weight against cut time, and the moments that hit the target,
/// found in the background. Beside the main window, which stays usable.
class CutWindow : public QDialog {
  Q_OBJECT

 public:
  CutWindow(SceneEditor* editor, SceneTarget* target, QWidget* parent = nullptr);
  ~CutWindow() override;

  /// Shows the window, in front of others, and the target; finds the moments if need be.
  void bringUp();

  /// The latest sweep, with the hits on the target as it is; null if there is none.
  const std::shared_ptr<const CutSweepResult>& result() const { return m_result; }

  // To a file of this name, whose ending names the kind. Messages say what went wrong.
  void saveChart(const QString& file);
  void saveTable(const QString& file);

 public slots:
  /// Sweeps the scene as the controls say; what is under way is given up.
  void find();
  void copyChart() const;
  void copyData() const;

 signals:
  /// The scene cuts all ropes at this time [s] from now on: the user chose it.
  void momentPicked(double cutTime);

 private:
  struct Work;

  void buildControls();
  QWidget* questionRow();
  QToolButton* exportButton();
  QWidget* resultArea();
  void listRuns();
  void showTarget();
  void noteScene();
  void forget();
  void begin(bool sweepsAnew);
  void finish(const std::vector<core::Hit>& hits, const core::Target& target);
  void goOn();
  void pick(double cutTime);
  bool findsByItself() const;
  core::CutSweepQuestion question() const;
  QString suggested(const QString& ending) const;

  SceneEditor* m_editor;
  SceneTarget* m_target;
  BackgroundTask* m_task;
  TaskRow* m_row;
  QSpinBox* m_weight;
  QComboBox* m_run;
  QuantityField* m_center;
  QuantityField* m_width;
  QuantityField* m_from;
  QuantityField* m_until;
  QToolButton* m_export;
  CutSweepChart* m_chart;
  HitTable* m_table;
  QLabel* m_found;
  QTimer* m_pause;               // so that hits are not looked for at every pixel of a drag
  double m_firstCut = 0;         // [s]
  double m_lastCut = 10;         // [s]
  bool m_wantsSweep = false;     // once what is under way has ended
  bool m_wantsHits = false;      // likewise
  std::shared_ptr<Work> m_work;  // the latest sweep; used by one thread at a time
  std::shared_ptr<const CutSweepResult> m_result;
};

}  // namespace ui
