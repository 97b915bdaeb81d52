#include "ui/panels/panel_title.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/style/icons.h"

namespace ui {
namespace {

constexpr QSize kIconSize(14, 14);
constexpr int kSpacing = 4;  // px

QToolButton* button(const QString& iconName, const QString& tip) {
  auto* button = new QToolButton;
  button->setIcon(icon(iconName));
  button->setIconSize(kIconSize);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  return button;
}

}  // namespace

PanelTitle::PanelTitle(QDockWidget* panel, QWidget* extra) : QWidget(panel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 4, 4, 0);
  layout->setSpacing(kSpacing);
  auto* name = new QLabel(panel->windowTitle());
  QFont bold = name->font();
  bold.setBold(true);
  name->setFont(bold);
  name->setContentsMargins(0, 0, kSpacing, 0);
  layout->addWidget(name);
  if (extra) layout->addWidget(extra);
  // Something extra may take the whole line if it likes to.
  const bool fills = extra && extra->sizePolicy().expandingDirections().testFlag(Qt::Horizontal);
  if (!fills) layout->addStretch(1);

  auto* floating = button("float", tr("Take the panel out of the window, or put it back"));
  auto* close = button("close", tr("Close the panel; the view menu brings it back"));
  layout->addWidget(floating);
  layout->addWidget(close);
  connect(floating, &QToolButton::clicked, panel,
          [panel] { panel->setFloating(!panel->isFloating()); });
  connect(close, &QToolButton::clicked, panel, &QWidget::close);
}

}  // namespace ui
