#include "ui/help/help_page.h"

#include <QEvent>
#include <QPainter>

namespace ui {
namespace {

constexpr int kFrameWidth = 2;  // px

}  // namespace

HelpPage::HelpPage(QWidget* parent) : QTextBrowser(parent) {
  setFrameShape(QFrame::NoFrame);
  setViewportMargins(kFrameWidth, kFrameWidth, kFrameWidth, kFrameWidth);
  setOpenLinks(false);
}

bool HelpPage::event(QEvent* event) {
  const bool isDone = QTextBrowser::event(event);
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
  if (event->type() == QEvent::Paint) paintFrame();
  return isDone;
}

void HelpPage::paintFrame() {
  const auto role = hasFocus() ? QPalette::Highlight : QPalette::Base;
  constexpr double kInset = kFrameWidth / 2.0;
  QPainter painter(this);
  painter.setPen(
      QPen(palette().color(role), kFrameWidth, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(QRectF(viewport()->geometry()).adjusted(-kInset, -kInset, kInset, kInset));
}

}  // namespace ui
