#pragma once

#include <QObject>

class QDropEvent;
class QMimeData;
class QWidget;

namespace ui {

class SceneFiles;

/// Opens a scene file that is dropped anywhere onto the window.
class SceneDrop : public QObject {
  Q_OBJECT

 public:
  SceneDrop(SceneFiles* files, QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void take(const QMimeData& data);

  SceneFiles* m_files;
  QWidget* m_window;
};

}  // namespace ui
