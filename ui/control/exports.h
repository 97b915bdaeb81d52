#pragma once

#include <functional>
#include <utility>

#include <QObject>
#include <QString>
#include <QStringList>

#include "ui/chart/chart_export.h"
#include "ui/view/scene_picture.h"

class QWidget;

namespace ui {

class RunController;

/// Saves what the window shows: chart, scene and figures. Messages say what went wrong.
class Exports : public QObject {
  Q_OBJECT

 public:
  /// @param chart  the chart as it is looked at at that moment
  Exports(const RunController* controller, std::function<ChartPicture()> chart, QWidget* window);

  /// @param pictured  what is drawn besides the runs at that moment
  void setPictured(std::function<PicturedMarks()> pictured) { m_pictured = std::move(pictured); }

  // To a file of this name, whose ending names the kind.
  /// @param size  in mm on paper
  void saveChart(const QString& file, QSizeF size = kUsualChartSize);
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
  std::function<ChartPicture()> m_chart;
  std::function<PicturedMarks()> m_pictured = [] { return PicturedMarks(); };
  QWidget* m_window;
};

}  // namespace ui
