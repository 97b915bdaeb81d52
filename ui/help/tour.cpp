#include "ui/help/tour.h"

#include <algorithm>
#include <array>

#include <QDockWidget>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/control/settings.h"
#include "ui/panels/playback_bar.h"
#include "ui/panels/timeline.h"
#include "ui/view/scene_area.h"

namespace ui {
namespace {

const QString kSeen = QStringLiteral("tourSeen");

constexpr int kMostWidth = 400;      // px, of a bubble of words
constexpr double kWidthShare = 0.5;  // of the window's, at most
constexpr int kGap = 18;             // px, from what is pointed at
constexpr int kEdge = 12;            // px, from the window's edge
constexpr int kRounding = 8;         // px
constexpr int kFrameWidth = 3;       // px, around what is pointed at
constexpr int kShade = 120;          // of 255, over the rest

}  // namespace

bool isTourDue() {
  return !Settings().isOn(kSeen, false);
}

Tour::Tour(QMainWindow* window) : QWidget(window) {
  setObjectName("tour");
  setAttribute(Qt::WA_DeleteOnClose);
  setAccessibleName(tr("Tour"));
  listHints(window);
  buildBubble();
  window->installEventFilter(this);
  setGeometry(window->rect());
  Settings().setOn(kSeen, true);
  QWidget::show();
  raise();
  show(0);
}

void Tour::listHints(QMainWindow* window) {
  m_hints = {
      {window->findChild<SceneArea*>(), tr("The scene"),
       tr("Weights on ropes. Filled ones follow the first method, rings the others. At the start "
          "drag a weight to turn its rope; the wheel zooms.")},
      {window->findChild<PlaybackBar*>(), tr("Play and cut"),
       tr("Space plays and stops. C cuts all ropes, R goes back to the start. Slow motion makes "
          "an impact last for seconds.")},
      {window->findChild<Timeline*>(), tr("Step by step"),
       tr("The arrow keys → and ← go by one step, I goes to the next impact. Drag on this line to "
          "see any moment again.")},
      {window->findChild<QDockWidget*>("charts"), tr("Where the energy goes"),
       tr("The total should be a flat line. What it climbs or falls was made or lost by the "
          "method, not by nature.")},
      {window->findChild<QDockWidget*>("runs"), tr("Methods side by side"),
       tr("Up to four methods compute the same scene. Choose them and their steps here, and see "
          "who is right. Lessons, at the top right, has scenes to begin with.")},
  };
}

void Tour::buildBubble() {
  auto* bubble = new QFrame(this);
  bubble->setFrameShape(QFrame::StyledPanel);
  bubble->setAutoFillBackground(true);
  m_bubble = bubble;
  m_title = new QLabel;
  QFont bold = font();
  bold.setBold(true);
  m_title->setFont(bold);
  m_words = new QLabel;
  m_words->setWordWrap(true);
  m_count = new QLabel;
  m_skip = new QPushButton(tr("Skip"));
  m_back = new QPushButton(tr("Back"));
  m_next = new QPushButton;
  connect(m_skip, &QPushButton::clicked, this, &Tour::end);
  connect(m_back, &QPushButton::clicked, this, [this] { show(m_hint - 1); });
  connect(m_next, &QPushButton::clicked, this, [this] { show(m_hint + 1); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_count);
  buttons->addStretch(1);
  for (QPushButton* button : {m_skip, m_back, m_next}) buttons->addWidget(button);
  auto* layout = new QVBoxLayout(m_bubble);
  layout->addWidget(m_title);
  layout->addWidget(m_words);
  layout->addLayout(buttons);
}

void Tour::show(int hint) {
  if (hint == hintCount()) {
    end();
    return;
  }
  m_hint = hint;
  const Hint& shown = m_hints[static_cast<std::size_t>(hint)];
  if (shown.target) shown.target->raise();  // a panel behind others comes forward
  m_title->setText(shown.title);
  m_words->setText(shown.words);
  m_count->setText(tr("%1 of %2").arg(hint + 1).arg(hintCount()));
  m_bubble->setAccessibleName(shown.title);
  m_bubble->setAccessibleDescription(shown.words);
  m_back->setEnabled(hint > 0);
  m_next->setText(hint + 1 < hintCount() ? tr("Next") : tr("Begin"));
  m_skip->setVisible(hint + 1 < hintCount());
  raise();
  placeBubble();
  m_next->setFocus();
  update();
}

QRect Tour::pointedAt() const {
  const QWidget* target = m_hints[static_cast<std::size_t>(m_hint)].target;
  if (!target || !target->isVisible()) return {};
  return QRect(target->mapTo(parentWidget(), QPoint()), target->size()).intersected(rect());
}

/// On the side of what it points at where there is room, else in front of it.
void Tour::placeBubble() {
  const int width = std::min(kMostWidth, static_cast<int>(this->width() * kWidthShare));
  m_bubble->setFixedWidth(width);
  m_bubble->setFixedHeight(m_bubble->layout()->hasHeightForWidth()
                               ? m_bubble->layout()->totalHeightForWidth(width)
                               : m_bubble->sizeHint().height());
  const QRect room = rect().adjusted(kEdge, kEdge, -kEdge, -kEdge);
  const QRect target = pointedAt();
  QRect place(QPoint(), m_bubble->size());
  const auto within = [&room](QRect moved) {
    moved.moveLeft(std::clamp(moved.left(), room.left(), room.right() - moved.width() + 1));
    moved.moveTop(std::clamp(moved.top(), room.top(), room.bottom() - moved.height() + 1));
    return moved;
  };
  place.moveCenter(target.isEmpty() ? room.center() : target.center());
  QRect best = within(place);
  if (!target.isEmpty()) {
    std::array<QRect, 4> sides = {best, best, best, best};
    sides[0].moveBottom(target.top() - kGap);
    sides[1].moveLeft(target.right() + kGap);
    sides[2].moveRight(target.left() - kGap);
    sides[3].moveTop(target.bottom() + kGap);
    const auto fits =
        std::ranges::find_if(sides, [&room](QRect side) { return room.contains(side); });
    if (fits != sides.end()) best = *fits;
  }
  m_bubble->move(best.topLeft());
}

void Tour::end() {
  close();
  parentWidget()->setFocus();
}

/// Keys are the tour's while it is there, even those that mean something in the window.
bool Tour::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
    placeBubble();
  } else if (watched == parentWidget() && event->type() == QEvent::LayoutRequest) {
    placeBubble();
    update();
  }
  return QWidget::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      end();
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (auto* button = qobject_cast<QPushButton*>(focusWidget())) button->click();
      break;
    default:
      break;  // it ends here: nothing behind the tour is for keys now
  }
}

void Tour::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF target = pointedAt();
  QPainterPath shade;
  shade.addRect(rect());
  QPainterPath hole;
  if (!target.isEmpty()) hole.addRoundedRect(target, kRounding, kRounding);
  painter.fillPath(shade.subtracted(hole), QColor(0, 0, 0, kShade));
  if (target.isEmpty()) return;
  const double inset = kFrameWidth / 2.0;
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFrameWidth));
  painter.drawRoundedRect(target.adjusted(inset, inset, -inset, -inset), kRounding, kRounding);
  // From the bubble's middle to the nearest point of what it is about.
  const QRectF words = m_bubble->geometry();
  if (words.intersects(target)) return;
  const QPointF from = words.center();
  const QPointF to(std::clamp(from.x(), target.left() + kGap,
                              std::max(target.right() - kGap, target.left() + kGap)),
                   std::clamp(from.y(), target.top() + kGap,
                              std::max(target.bottom() - kGap, target.top() + kGap)));
  painter.drawLine(from, to);
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(to, kFrameWidth, kFrameWidth);
}

/// Tab goes round its buttons.
bool Tour::focusNextPrevChild(bool next) {
  std::vector<QPushButton*> buttons;
  for (QPushButton* button : {m_skip, m_back, m_next})
    if (button->isVisible() && button->isEnabled()) buttons.push_back(button);
  if (buttons.empty()) return false;  // it is going
  const auto focused = std::ranges::find(buttons, focusWidget());
  const auto count = buttons.size();
  const auto at = static_cast<std::size_t>(focused - buttons.begin());
  buttons[(focused == buttons.end() ? 0 : at + (next ? 1 : count - 1)) % count]->setFocus(
      Qt::TabFocusReason);
  return true;
}

}  // namespace ui
