#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/chart/charted_run.h"

class QWidget;

namespace ui {

class RunController;

/// Saves what the window shows: chart, scene and figures. Messages say what went wrong.
class Exports : public QObject {
  Q_OBJECT

 public:
  /// @param charted  the runs the chart shows at that moment
  Exports(const RunController* controller, std::function<std::vector<ChartedRun>()> charted,
          QWidget* window);

  // To a file of this name, whose ending names the kind.
  void saveChart(const QString& file);
  void savePicture(const QString& file);
  void saveLedger(const QString& file, int run);

 public slots:
  void askAndSaveChart();
  void askAndSavePicture();
  void askAndSaveLedger(int run);

 signals:
  /// Something went well, in words.
  void done(const QString& message);

 private:
  QString sceneName() const;
  QString suggested(const QString& what, const QString& ending) const;
  void report(const QString& file, const QString& error);

  const RunController* m_controller;
  std::function<std::vector<ChartedRun>()> m_charted;
  QWidget* m_window;
};

}  // namespace ui
