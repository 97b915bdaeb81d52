#pragma once

#include <QByteArray>
#include <QSettings>
#include <QSizeF>

#include "ui/style/appearance.h"
#include "ui/view/scene_view.h"

namespace ui {

/// What the program remembers about its user between two starts.
///
/// A value that is missing or makes no sense reads as the default.
class Settings {
 public:
  Settings();

  PainterChoice painter() const;
  void setPainter(PainterChoice choice);

  ThemeChoice theme() const;
  void setTheme(ThemeChoice choice);

  /// Of exported charts, in mm on paper.
  QSizeF chartSize() const;
  void setChartSize(QSizeF size);

  /// Places and sizes of panels, as QMainWindow gives them; empty: the usual ones.
  QByteArray panels() const;
  void setPanels(const QByteArray& panels);

  /// The lesson whose text was put away; another one shows its own.
  QString hiddenLesson() const;
  void setHiddenLesson(const QString& name);

 private:
  QSettings m_store;
};

}  // namespace ui
