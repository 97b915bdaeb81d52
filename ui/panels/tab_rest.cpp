#include "ui/panels/tab_rest.h"

#include <QDockWidget>
#include <QEvent>

namespace ui {

TabRest::TabRest(QDockWidget* panel) : QObject(panel), m_panel(panel) {
  // Or the panel would be as small as its title while its content is hidden.
  QSizePolicy policy = panel->widget()->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  panel->widget()->setSizePolicy(policy);
  panel->installEventFilter(this);
  connect(panel, &QDockWidget::visibilityChanged, this, &TabRest::applySight);
}

/// Of panels that are behind from the start nothing is told but that they move away.
bool TabRest::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Move || event->type() == QEvent::Show) applySight();
  return QObject::eventFilter(watched, event);
}

/// Behind a tab is outside of the window.
void TabRest::applySight() const {
  const bool isInside = m_panel->parentWidget()->rect().intersects(m_panel->geometry());
  const bool isSeen = m_panel->isVisible() && (m_panel->isFloating() || isInside);
  m_panel->widget()->setVisible(isSeen);
  // Not hidden: the place of a title bar is lost for good then.
  if (QWidget* title = m_panel->titleBarWidget()) title->setEnabled(isSeen);
}

}  // namespace ui
