#include "ui/panels/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "ui/style/icons.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kIconSize = 22;
constexpr int kEdge = 4;  // px: the colored stripe at the left

}  // namespace

MessageBar::MessageBar(const QString& offer, const QString& otherOffer, QWidget* parent)
    : QFrame(parent),
      m_icon(new QLabel),
      m_text(new QLabel),
      m_button(new QToolButton),
      m_otherButton(new QToolButton) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12 + kEdge, 6, 8, 6);
  layout->addWidget(m_icon);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_button);
  layout->addWidget(m_otherButton);
  m_icon->setPixmap(icon("warning").pixmap(kIconSize));
  m_text->setTextFormat(Qt::PlainText);  // a scene's name may stand in it
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_button->setText(offer);
  m_button->setVisible(!offer.isEmpty());
  m_otherButton->setText(otherOffer);
  m_otherButton->setVisible(!otherOffer.isEmpty());
  for (QToolButton* button : {m_button, m_otherButton}) button->setFocusPolicy(Qt::TabFocus);
  connect(m_button, &QToolButton::clicked, this, &MessageBar::accepted);
  connect(m_otherButton, &QToolButton::clicked, this, &MessageBar::otherAccepted);
  hide();
}

void MessageBar::say(const QString& message) {
  m_text->setText(message);
  setVisible(!message.isEmpty());
}

QString MessageBar::message() const {
  return m_text->text();
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) m_icon->setPixmap(icon("warning").pixmap(kIconSize));
}

void MessageBar::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::of(palette());
  QColor tint = theme.drift;
  tint.setAlphaF(theme.dark ? 0.22F : 0.10F);
  QPainter painter(this);
  painter.fillRect(rect(), tint);
  painter.fillRect(QRect(0, 0, kEdge, height()), theme.drift);
}

}  // namespace ui
