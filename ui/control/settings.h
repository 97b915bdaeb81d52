#pragma once

#include <QByteArray>
#include <QSettings>
#include <QSizeF>
#include <QString>
#include <QStringList>

#include "ui/control/translations.h"
#include "ui/style/appearance.h"
#include "ui/view/scene_view.h"

namespace ui {

/// What the program remembers about its user between two starts.
///
/// A value that is missing or makes no sense reads as the default.
class Settings {
 public:
  Settings();

  /// Why something is not remembered, in words; empty where all is well. A damaged file is told
  /// of once, when it is first read: what is written next mends it.
  QString trouble() const;

  PainterChoice painter() const;
  void setPainter(PainterChoice choice);

  Language language() const;
  void setLanguage(Language language);

  ThemeChoice theme() const;
  void setTheme(ThemeChoice choice);

  TextSize textSize() const;
  void setTextSize(TextSize size);

  /// Of exported charts, in mm on paper.
  QSizeF chartSize() const;
  void setChartSize(QSizeF size);

  /// Places and sizes of panels, as QMainWindow gives them; empty: the usual ones.
  QByteArray panels() const;
  void setPanels(const QByteArray& panels);

  /// Place and size of the window, as QWidget gives them; empty: the usual ones.
  QByteArray geometry() const;
  void setGeometry(const QByteArray& geometry);

  /// Simulated seconds per second, > 0.
  double speed() const;
  void setSpeed(double speed);

  /// Id of the kind of chart shown; may be none that exists.
  QString chartKind() const;
  void setChartKind(const QString& id);

  /// Whether a switch of the window is on.
  bool isOn(const QString& name, bool usually) const;
  void setOn(const QString& name, bool on);

  /// The latest first.
  QStringList recentFiles() const;
  void setRecentFiles(const QStringList& files);

  /// A file, or the name of a built-in scene; empty: none.
  QString lastScene() const;
  void setLastScene(const QString& fileOrName);

  /// The lesson whose text was put away; another one shows its own.
  QString hiddenLesson() const;
  void setHiddenLesson(const QString& name);

 private:
  QSettings m_store;
};

}  // namespace ui
