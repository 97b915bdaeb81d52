#pragma once

#include <QWidget>

class QComboBox;
class QTableWidget;

namespace core {
class Run;
}

namespace ui {

class RedrawLimiter;
class RunController;
class SeparationChart;

/// The runs side by side in figures: how far each is from one of them, now and over time, its
/// numerical drift, and the slopes it evaluated.
class ComparisonPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonPanel(const RunController* controller, QWidget* parent = nullptr);

  /// Chooses the run that distances are measured from, wherever it is laid out; hidden while
  /// there is but one.
  QWidget* chooser() const;

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void fitToFont();
  void buildTable();
  void listRuns();
  void chooseBase();
  void showFigures();
  void showRow(int run);
  QString distanceText(int run) const;
  void paintMarks();
  void set(int row, int column, const QString& text);

  const RunController* m_controller;
  QComboBox* m_chooser;
  QTableWidget* m_table;
  SeparationChart* m_chart;
  RedrawLimiter* m_limiter;
  bool m_hadReference = false;  // a new one becomes what the others are compared with
};

}  // namespace ui
