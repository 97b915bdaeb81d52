#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "core/trade/bounded_step.h"
#include "core/trade/stability_map.h"
#include "ui/chart/stability_plot.h"
#include "ui/chart/trade_view.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace ui {

class BackgroundTask;
class QuantityField;
class SceneEditor;
class TaskRow;

/// Finds, in the background, the largest step at which each method stays bounded on the scene
/// that runs, and maps one method over step × rope length or air density.
class StabilityPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StabilityPanel(SceneEditor* editor, QWidget* parent = nullptr);

  /// The latest map; null if there is none.
  const std::shared_ptr<const core::StabilityMap>& map() const { return m_map; }

  /// Maps the scene as the controls say if nothing is computed just now.
  void compute();

  /// To a file of this name, whose ending names the kind. A message says what went wrong.
  void saveMap(const QString& file);

 private:
  struct Result;

  void buildControls();
  void listQuantities();
  void show(const Result& result);
  void forget();
  void askAndSaveMap();

  SceneEditor* m_editor;
  BackgroundTask* m_task;
  TaskRow* m_row;
  QComboBox* m_method;
  QComboBox* m_quantity;
  QuantityField* m_until;
  QToolButton* m_export;
  QLabel* m_steps;
  TradeView<StabilityPlot>* m_chart;
  double m_time = 10;  // [s]
  QString m_sceneName;
  std::shared_ptr<const core::StabilityMap> m_map;
};

}  // namespace ui
