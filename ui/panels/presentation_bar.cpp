#include "ui/panels/presentation_bar.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/control/commands.h"

namespace ui {
namespace {

constexpr int kGap = 8;             // to the edge of the screen [px]
constexpr double kIconShare = 1.6;  // of a line's height

constexpr Command kOffered[] = {Command::kStepBack,   Command::kPlay,          Command::kStep,
                                Command::kCut,        Command::kReset,         Command::kSlower,
                                Command::kFaster,     Command::kPreviousChart, Command::kNextChart,
                                Command::kLessonText, Command::kLessons,       Command::kPresent};

}  // namespace

PresentationBar::PresentationBar(const Commands& commands, QWidget* parent) : QFrame(parent) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(4);
  for (const Command command : kOffered) {
    auto* button = new QToolButton;
    button->setDefaultAction(commands.action(command));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(button);
  }
  sizeButtons();
}

void PresentationBar::place() {
  adjustSize();
  const QSize free = parentWidget()->size() - size();
  move(free.width() / 2, free.height() - kGap);
  raise();
}

void PresentationBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::FontChange) sizeButtons();
}

void PresentationBar::sizeButtons() {
  const int side = static_cast<int>(kIconShare * fontMetrics().height());
  for (QToolButton* button : findChildren<QToolButton*>()) button->setIconSize({side, side});
}

}  // namespace ui
