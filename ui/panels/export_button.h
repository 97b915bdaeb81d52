#pragma once

#include <functional>

#include <QString>
#include <QToolButton>

namespace ui {

/// Asks where to save a chart, as a picture, or its figures, as a table.
class ExportButton : public QToolButton {
  Q_OBJECT

 public:
  /// @param suggested  name for a file, without its ending; asked for when it is needed
  explicit ExportButton(std::function<QString()> suggested, QWidget* parent = nullptr);

 signals:
  /// The user wants the chart in this file, whose ending names the kind of picture.
  void chartWanted(const QString& file);
  /// The user wants the figures in this file.
  void tableWanted(const QString& file);
};

}  // namespace ui
