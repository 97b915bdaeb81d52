#pragma once

#include <set>
#include <vector>

#include <QWidget>

#include "ui/chart/chart_export.h"

class QComboBox;
class QMenu;
class QSpinBox;
class QTabBar;

namespace ui {

class ChartWidget;
class Commands;
class RunController;

/// What a charts panel shows, in no language.
struct ChartsView {
  int kind = 0;                        ///< index in chartKinds()
  int run = -1;                        ///< index; −1: all
  int weight = -1;                     ///< index; −1: all
  std::set<std::size_t> hiddenCurves;  ///< by their places in the legend
  std::set<std::size_t> hiddenRuns;
};

/// Charts of all runs or of a chosen one, of all weights or of a chosen one; one kind at a
/// time, chosen by tabs.
class ChartsPanel : public QWidget {
  Q_OBJECT

 public:
  ChartsPanel(RunController* controller, const Commands& commands, QWidget* parent = nullptr);

  ChartWidget* chart() const { return m_chart; }
  /// The shown chart as it is looked at, for paper.
  ChartPicture picture() const;

  /// Tabs and choosers, wherever they are laid out.
  QWidget* choosers() const { return m_choosers; }

  /// @param kind  index in chartKinds()
  void chooseKind(int kind);
  /// Index of the kind shown.
  int kind() const;
  /// Shows the run with this index; −1: all.
  void chooseRun(int run);
  /// Shows the weight with this index; −1: all.
  void chooseWeight(int weight);
  /// Index of the weight shown; −1: all.
  int weight() const;

  ChartsView view() const;
  void setView(const ChartsView& view);

 public slots:
  void chooseNextKind();
  void choosePreviousKind();

 private:
  void buildChoosers();
  void buildMenu(const Commands& commands);
  void connectCommands(const Commands& commands);
  void listRuns();
  void showChosen();
  void listCurves();
  ChartSubject subject() const;
  ChartedRun charted(int run) const;
  std::vector<int> chosenWeights() const;

  RunController* m_controller;
  QWidget* m_choosers;
  QTabBar* m_kinds;
  QSpinBox* m_weight;
  QComboBox* m_runs;
  QMenu* m_menu;
  QMenu* m_curves;
  ChartWidget* m_chart;
};

}  // namespace ui
