#pragma once

#include <memory>

#include <QWidget>

#include "core/trade/measurement.h"
#include "ui/chart/trade_view.h"
#include "ui/chart/work_precision_plot.h"

class QComboBox;
class QLabel;
class QSplitter;

namespace ui {

class BackgroundTask;
class ExportButton;
class MeasurementTable;
class QuantityField;
class SceneEditor;
class TaskRow;

/// Measures the scene that runs, all methods at many steps, in the background; shows what was
/// found as a chart, a table and a sentence.
class AccuracyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AccuracyPanel(SceneEditor* editor, QWidget* parent = nullptr);

  /// The latest measurement; null if there is none.
  const std::shared_ptr<const core::Measurement>& measurement() const { return m_measurement; }

  /// Measures over that time [s] if nothing is measured just now.
  void measure(double until);

  // To a file of this name; for the chart its ending names the kind. Messages say what went
  // wrong.
  void saveChart(const QString& file);
  void saveTable(const QString& file);

 signals:
  /// The user picked a point: method and setting to open as a run.
  void picked(const core::Solver& solver);

 private:
  void buildControls();
  QSplitter* resultArea();
  void show(std::shared_ptr<const core::Measurement> measurement, const QString& sceneName);
  void showAgainst();
  void showFound();
  void divideRoom();
  void forget();

  SceneEditor* m_editor;
  BackgroundTask* m_task;
  TaskRow* m_row;
  QuantityField* m_until;
  QComboBox* m_against;
  QComboBox* m_error;
  ExportButton* m_export;
  TradeView<WorkPrecisionPlot>* m_chart;
  MeasurementTable* m_table;
  QSplitter* m_results;  // both, once there are any
  QLabel* m_found;
  double m_time = 10;  // [s]
  QString m_sceneName;
  std::shared_ptr<const core::Measurement> m_measurement;
};

}  // namespace ui
