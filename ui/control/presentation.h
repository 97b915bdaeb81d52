#pragma once

#include <vector>

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QRect>

class QDockWidget;
class QFont;
class QMainWindow;
class QTimer;
class QWidget;

namespace ui {

class Appearance;
class Commands;
class LessonGuide;
class PresentationBar;
class PresentationHeader;
class RunController;

/// Fills the screen with the scene and one chart, in large type. Buttons come when the mouse
/// moves or a key is pressed, and go again. Afterwards the window is laid out as it was.
class Presentation : public QObject {
  Q_OBJECT

 public:
  /// What the window is made of, as far as it is presented or put away.
  struct Parts {
    QMainWindow* window;
    Appearance* appearance;
    RunController* controller;
    LessonGuide* lessons;
    QDockWidget* charts;
    PresentationHeader* header;  ///< shown only now
    QWidget* scene;
    std::vector<QWidget*> controls;  ///< below the scene; put away
  };

  Presentation(const Commands& commands, Parts parts, QObject* parent);
  ~Presentation() override;

  bool isOn() const { return m_on; }
  PresentationBar* bar() const { return m_bar; }
  /// Runs while buttons are shown; when it ends they go.
  QTimer* hideTimer() const { return m_hide; }

 public slots:
  void setOn(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void enter();
  void leave();
  void putAway();
  void setType(const QFont& font);
  void placeChart();
  void restoreLayout();
  void showBar();
  void hideBar();
  bool takesEscape(const QObject* watched) const;

  const Commands& m_commands;
  Parts m_parts;
  PresentationBar* m_bar;
  QTimer* m_hide;
  QTimer* m_settling;  // after leaving, while the desktop gives the window its size back
  bool m_on = false;

  // How the window was before.
  QByteArray m_layout;
  QRect m_geometry;
  Qt::WindowStates m_state;
  QWidget* m_chartTitle = nullptr;
  QPointer<QWidget> m_focus;
};

}  // namespace ui
