#pragma once

#include <QSettings>

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

 private:
  QSettings m_store;
};

}  // namespace ui
