#include "ui/control/presentation.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QScreen>
#include <QStatusBar>
#include <QTimer>

#include "ui/control/commands.h"
#include "ui/control/lesson_guide.h"
#include "ui/control/run_controller.h"
#include "ui/panels/presentation_bar.h"
#include "ui/panels/presentation_header.h"
#include "ui/style/appearance.h"

namespace ui {
namespace {

constexpr int kHideAfter = 3000;      // ms
constexpr int kSettleWithin = 1000;   // ms
constexpr double kSideShare = 0.42;   // of the width, for a chart at the side
constexpr double kBelowShare = 0.38;  // of the height, for a chart below

/// Pixels a metre gets when the room fills this much of the screen.
double scaleOf(const core::Room& room, QSizeF space) {
  return std::min(space.width() / room.width, space.height() / room.height);
}

}  // namespace

Presentation::Presentation(const Commands& commands, Parts parts, QObject* parent)
    : QObject(parent),
      m_commands(commands),
      m_parts(std::move(parts)),
      m_bar(new PresentationBar(commands, m_parts.window)),
      m_hide(new QTimer(this)),
      m_settling(new QTimer(this)) {
  m_bar->hide();
  m_hide->setSingleShot(true);
  m_settling->setSingleShot(true);
  m_settling->setInterval(kSettleWithin);
  connect(m_hide, &QTimer::timeout, this, &Presentation::hideBar);
  connect(commands.action(Command::kPresent), &QAction::triggered, this, &Presentation::setOn);
  connect(m_parts.controller, &RunController::timeShown, m_parts.header,
          &PresentationHeader::showTime);
  connect(m_parts.controller, &RunController::restarted, this, [this] {
    if (m_on) placeChart();
  });
  m_parts.window->installEventFilter(this);
}

Presentation::~Presentation() {
  delete m_bar;
}

void Presentation::setOn(bool on) {
  if (on == m_on) return;
  if (on) {
    enter();
  } else {
    leave();
  }
  m_commands.action(Command::kPresent)->setChecked(m_on);
}

void Presentation::enter() {
  QMainWindow* window = m_parts.window;
  m_on = true;
  m_layout = window->saveState();
  m_geometry = window->geometry();
  m_state = window->windowState();
  m_focus = window->focusWidget();
  m_parts.lessons->present(m_parts.header->sentence());
  putAway();
  m_parts.header->showTime(m_parts.controller->time());
  m_parts.header->show();
  setType(m_parts.appearance->presentedFont(window->screen()->size().height()));
  window->setWindowState(m_state | Qt::WindowFullScreen);
  placeChart();
  m_parts.scene->setFocus();
  qApp->installEventFilter(this);
  showBar();
}

/// Of what is presented alone: the rest of the window keeps its sizes.
void Presentation::setType(const QFont& font) {
  m_bar->setFont(font);
  m_parts.charts->setFont(font);
  for (QObject* child : m_parts.window->centralWidget()->children()) {
    auto* part = qobject_cast<QWidget*>(child);
    if (part && std::ranges::count(m_parts.controls, part) == 0) part->setFont(font);
  }
}

/// All but the scene and the chart.
void Presentation::putAway() {
  QMainWindow* window = m_parts.window;
  for (QDockWidget* dock : window->findChildren<QDockWidget*>())
    if (dock != m_parts.charts) dock->hide();
  window->menuBar()->hide();
  window->statusBar()->hide();
  for (QWidget* control : m_parts.controls) control->hide();
  m_chartTitle = m_parts.charts->titleBarWidget();
  m_parts.charts->setTitleBarWidget(new QWidget);
  m_parts.charts->setFloating(false);
  m_parts.charts->show();
}

/// Beside the scene or below it, where the room is larger.
void Presentation::placeChart() {
  QMainWindow* window = m_parts.window;
  const core::Room& room = m_parts.controller->scene().room;
  const QSizeF screen = window->size();
  const bool beside = scaleOf(room, {screen.width() * (1 - kSideShare), screen.height()}) >
                      scaleOf(room, {screen.width(), screen.height() * (1 - kBelowShare)});
  const Qt::DockWidgetArea area = beside ? Qt::RightDockWidgetArea : Qt::BottomDockWidgetArea;
  if (window->dockWidgetArea(m_parts.charts) != area) window->addDockWidget(area, m_parts.charts);
  if (beside) {
    window->resizeDocks({m_parts.charts}, {static_cast<int>(screen.width() * kSideShare)},
                        Qt::Horizontal);
  } else {
    window->resizeDocks({m_parts.charts}, {static_cast<int>(screen.height() * kBelowShare)},
                        Qt::Vertical);
  }
}

void Presentation::leave() {
  QMainWindow* window = m_parts.window;
  qApp->removeEventFilter(this);
  m_on = false;
  m_hide->stop();
  hideBar();
  window->unsetCursor();
  m_parts.header->hide();
  setType(QFont());
  delete m_parts.charts->titleBarWidget();
  m_parts.charts->setTitleBarWidget(m_chartTitle);
  window->menuBar()->show();
  window->statusBar()->show();
  for (QWidget* control : m_parts.controls) control->show();
  window->setWindowState(m_state);
  restoreLayout();
  if (!m_state.testFlag(Qt::WindowMaximized)) window->setGeometry(m_geometry);
  restoreLayout();
  m_settling->start();
  m_parts.lessons->present(nullptr);
  if (m_focus) m_focus->setFocus();
}

void Presentation::restoreLayout() {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  m_parts.window->restoreState(m_layout);
}

void Presentation::showBar() {
  m_parts.window->unsetCursor();
  m_bar->show();
  m_bar->place();
  m_hide->start(kHideAfter);
}

void Presentation::hideBar() {
  if (m_on && m_bar->underMouse()) {
    m_hide->start(kHideAfter);
    return;
  }
  m_bar->hide();
  if (m_on) m_parts.window->setCursor(Qt::BlankCursor);
}

/// Who is on the way somewhere stops there first.
bool Presentation::takesEscape(const QObject* watched) const {
  const auto* widget = qobject_cast<const QWidget*>(watched);
  return widget && widget->window() == m_parts.window &&
         !m_commands.action(Command::kStopTravelling)->isEnabled();
}

bool Presentation::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_parts.window && event->type() == QEvent::Resize) {
    if (m_on) {
      placeChart();
      m_bar->place();
    } else if (m_settling->isActive()) {
      QTimer::singleShot(0, this, &Presentation::restoreLayout);
    }
    return false;
  }
  if (!m_on) return false;
  switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
      showBar();
      return false;
    case QEvent::ShortcutOverride:
      showBar();
      if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || !takesEscape(watched))
        return false;
      setOn(false);
      event->accept();
      return true;
    default:
      return false;
  }
}

}  // namespace ui
