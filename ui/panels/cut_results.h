#pragma once

#include <memory>

#include <QString>
#include <QWidget>

#include "ui/chart/cut_sweep_result.h"

class QLabel;

namespace ui {

class CutSweepChart;
class ExportButton;
class HitTable;

/// What a sweep of cut times has found, as a chart, a table and a sentence, to look at and to
/// take along.
class CutResults : public QWidget {
  Q_OBJECT

 public:
  explicit CutResults(QWidget* parent = nullptr);

  /// Saves or copies what is shown; for a row of controls.
  ExportButton* exportButton() const { return m_export; }

  /// Null if there is none.
  const std::shared_ptr<const CutSweepResult>& result() const { return m_result; }
  /// Shows it and says what was found; null: nothing is found yet.
  void setResult(std::shared_ptr<const CutSweepResult> result);
  /// The same result for another target, whose hits are not known yet.
  void showTarget(const core::Target& target);
  /// Says this in place of what was found.
  void say(const QString& words);

  // To a file of this name, whose ending names the kind. Messages say what went wrong.
  void saveChart(const QString& file);
  void saveTable(const QString& file);
  void copyChart() const;
  void copyData() const;

 signals:
  /// The user chose a moment to cut at [s].
  void momentPicked(double cutTime);

 private:
  void addCopying();

  std::shared_ptr<const CutSweepResult> m_result;
  ExportButton* m_export;
  CutSweepChart* m_chart;
  HitTable* m_table;
  QLabel* m_found;
};

}  // namespace ui
