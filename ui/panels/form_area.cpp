#include "ui/panels/form_area.h"

#include <algorithm>

#include <QEvent>
#include <QScreen>
#include <QScrollBar>

namespace ui {
namespace {

// Of the screen that a form may insist on.
constexpr double kMostWidth = 0.43;
constexpr double kMostHeight = 0.36;

}  // namespace

FormArea::FormArea(QWidget* form, Height height) : m_height(height) {
  setWidget(form);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);  // the fields in it have it
  fitToForm();
}

bool FormArea::eventFilter(QObject* watched, QEvent* event) {
  const bool handled = QScrollArea::eventFilter(watched, event);
  if (watched == widget() && event->type() == QEvent::LayoutRequest) fitToForm();
  return handled;
}

void FormArea::fitToForm() {
  const QSize available = screen()->availableSize();
  const int wanted = widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
  const int most = static_cast<int>(available.width() * kMostWidth);
  setHorizontalScrollBarPolicy(wanted > most ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  setMinimumWidth(std::min(wanted, most));
  if (m_height == Height::kScrolls) return;
  setMinimumHeight(
      std::min(sizeHint().height(), static_cast<int>(available.height() * kMostHeight)));
}

}  // namespace ui
