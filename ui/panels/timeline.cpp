#include "ui/panels/timeline.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/chart/nice_scale.h"
#include "ui/control/event_navigator.h"
#include "ui/control/event_words.h"
#include "ui/control/run_controller.h"
#include "ui/style/event_mark.h"
#include "ui/style/theme.h"

namespace ui {
namespace {

// All in px.
constexpr double kMark = 11;
constexpr double kRow = 13;
constexpr double kTrack = 8;
constexpr double kHandle = 14;
constexpr double kGap = 8;
constexpr double kReach = 7;  // around a sign that is pressed

constexpr double kShortest = 2;  // s that are shown at least
constexpr int kIntervals = 6;

QString secondsText(double time, int decimals) {
  return Timeline::tr("%1 s").arg(QLocale().toString(time, 'f', decimals));
}

NiceScale scaleTo(double end) {
  return niceScale(0, std::max(end, kShortest), kIntervals);
}

}  // namespace

Timeline::Timeline(RunController* controller, const EventNavigator* events, QWidget* parent)
    : QWidget(parent), m_controller(controller), m_events(events) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Timeline"));
  setAccessibleDescription(
      tr("The recording from its start to its end, with marks for events. A click or dragging "
         "shows another moment; Home, End and the arrow keys do, too."));
  setCursor(Qt::PointingHandCursor);
  const auto refresh = [this] { update(); };
  connect(controller, &RunController::restarted, this, [this] { m_marksKey = {}; });
  connect(controller, &RunController::timeShown, this, refresh);
  connect(events, &EventNavigator::runChanged, this, refresh);
}

QSize Timeline::sizeHint() const {
  return {400, static_cast<int>(std::ceil(2 * kRow + std::max(kRow, kHandle) + 2))};
}

double Timeline::lastTime() const {
  return scaleTo(m_controller->recordedUntil()).highest;
}

/// Between the words for both ends.
QRectF Timeline::track() const {
  const double left = kGap + fontMetrics().horizontalAdvance(secondsText(0, 0)) + kGap;
  const double right = fontMetrics().horizontalAdvance(QStringLiteral("0000.0 s")) + 2 * kGap;
  return {left, (height() - kTrack) / 2, std::max(width() - left - right, 1.0), kTrack};
}

double Timeline::positionOf(double time) const {
  const QRectF line = track();
  return line.left() + line.width() * time / lastTime();
}

double Timeline::timeAt(double position) const {
  const QRectF line = track();
  return std::max(0.0, (position - line.left()) / line.width() * lastTime());
}

// Impacts above the line, what happens to ropes on it, where weights stop or turn round below.
double Timeline::rowOf(core::EventKind kind) const {
  const double middle = height() / 2.0;
  if (belongsTo(EventGroup::kImpacts, kind)) return middle - kRow;
  const bool isOnRope = belongsTo(EventGroup::kCuts, kind) || belongsTo(EventGroup::kRopes, kind);
  return isOnRope ? middle : middle + kRow;
}

const std::vector<TimelineMark>& Timeline::marks() const {
  const core::EventLog& log = m_events->log();
  const double apart = kMark / track().width() * lastTime();
  const MarksKey key{&log, log.revision(), log.events().size(), apart};
  if (key != m_marksKey) m_marks = timelineMarks(log.events(), apart);
  m_marksKey = key;
  return m_marks;
}

void Timeline::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::of(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme.background);
  paintTrack(painter, theme);
  paintEnds(painter, theme);
  paintBeginOfEvents(painter, theme);
  for (const TimelineMark& mark : marks()) {
    const QPointF centre(positionOf(mark.time), rowOf(mark.kind));
    drawEventMark(painter, mark.kind, centre, kMark, theme);
  }
  paintMoment(painter, theme);
}

void Timeline::paintTrack(QPainter& painter, const Theme& theme) const {
  const auto fill = [&](double until, const QColor& color) {
    QRectF part = track();
    part.setRight(positionOf(until));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawRoundedRect(part, kTrack / 2, kTrack / 2);
  };
  fill(lastTime(), theme.grid);
  QColor recorded = palette().color(QPalette::Highlight);
  recorded.setAlphaF(0.35F);
  fill(m_controller->recordedUntil(), recorded);
  fill(m_controller->time(), palette().color(QPalette::Highlight));
}

void Timeline::paintEnds(QPainter& painter, const Theme& theme) const {
  const NiceScale scale = scaleTo(m_controller->recordedUntil());
  const QRectF line = track();
  painter.setPen(theme.faintText);
  painter.drawText(QRectF(0, 0, line.left() - kGap, height()), Qt::AlignRight | Qt::AlignVCenter,
                   secondsText(0, 0));
  painter.drawText(QRectF(line.right() + kGap, 0, width() - line.right() - kGap, height()),
                   Qt::AlignLeft | Qt::AlignVCenter, secondsText(scale.highest, scale.decimals()));
}

/// The log of events is bounded: says from when on they are known.
void Timeline::paintBeginOfEvents(QPainter& painter, const Theme& theme) const {
  const core::EventLog& log = m_events->log();
  if (log.forgotten() == 0 || log.events().empty()) return;
  const double begin = log.events().front().time;
  const QRectF line = track();
  const QRectF unknown(line.left(), 0, positionOf(begin) - line.left(), height());
  painter.fillRect(unknown, QBrush(theme.grid, Qt::BDiagPattern));
  painter.setPen(theme.faintText);
  const QString words = tr("events from %1").arg(secondsText(begin, 1));
  if (fontMetrics().horizontalAdvance(words) < unknown.width())
    painter.drawText(unknown, Qt::AlignRight | Qt::AlignTop, words);
}

void Timeline::paintMoment(QPainter& painter, const Theme& theme) const {
  const double x = positionOf(m_controller->time());
  painter.setPen(QPen(theme.text, 2));
  painter.drawLine(QPointF(x, 1), QPointF(x, height() - 1));
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(QPointF(x, height() / 2.0), kHandle / 2, kHandle / 2);
}

/// The event whose sign is there; null if none is.
const core::Event* Timeline::eventNear(QPointF position) const {
  const TimelineMark* nearest = nullptr;
  double least = kReach;
  for (const TimelineMark& mark : marks()) {
    const QPointF distance = position - QPointF(positionOf(mark.time), rowOf(mark.kind));
    if (std::abs(distance.y()) > kRow / 2 || std::abs(distance.x()) > least) continue;
    least = std::abs(distance.x());
    nearest = &mark;
  }
  if (!nearest) return nullptr;
  const auto events = m_events->log().events();
  auto event = std::ranges::lower_bound(events, nearest->time, {}, &core::Event::time);
  while (event->kind != nearest->kind) ++event;
  return &*event;
}

QString Timeline::wordsAt(QPointF position) const {
  const core::Event* event = eventNear(position);
  if (!event) return secondsText(timeAt(position.x()), 3);
  return tr("%1 s: %2, weight: %3")
      .arg(QLocale().toString(event->time, 'f', 3), eventWords(event->kind), whoWords(*event));
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), wordsAt(help->pos()), this);
  return true;
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_isDragged = true;
  m_playsAfterDrag = m_controller->isPlaying();
  m_controller->pause();
  const core::Event* pressed = eventNear(event->position());
  m_controller->showTime(pressed ? pressed->time : timeAt(event->position().x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (m_isDragged) m_controller->showTime(timeAt(event->position().x()));
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_isDragged) return;
  m_isDragged = false;
  if (m_playsAfterDrag) m_controller->play();
}

}  // namespace ui
