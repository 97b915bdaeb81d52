#include "ui/chart/chart_widget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QChart>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMimeData>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QWheelEvent>

#include "ui/chart/chart_readings.h"
#include "ui/chart/chart_table.h"
#include "ui/chart/chart_zoom.h"
#include "ui/chart/curves_item.h"

namespace ui {

namespace {

// A frame's time more or less, so that each second frame at 60 Hz draws.
constexpr double kShortestPause = 25;  // [ms]
// A pause is so many times as long as the work before it: most of the time is the scene's.
constexpr double kPausePerWork = 4;
constexpr double kLeastTime = 2;  // [s]
// So that an update takes a small part of a 30th of a second, the scene the rest.
constexpr std::size_t kMostPoints = 10000;
constexpr int kLeastWidth = 360;                       // px
constexpr double kFocusWidth = 2;                      // px
constexpr int kLeastHeight = 140, kUsualHeight = 180;  // px, on a small screen and others

constexpr double kWheelFactor = 1.2;  // for each notch
constexpr double kKeyFactor = 1.5;
constexpr double kKeyMove = 0.1;      // of what is shown
constexpr double kGrabDistance = 7;   // [px]
constexpr double kClickDistance = 5;  // a drag is longer [px]
constexpr double kReadDistance = 40;  // from a curve that is not over time [px]

struct KeyMove {
  int key;
  double x;
  double y;
};

constexpr std::array kKeyMoves = {
    KeyMove{Qt::Key_Left, -kKeyMove, 0}, KeyMove{Qt::Key_Right, kKeyMove, 0},
    KeyMove{Qt::Key_Down, 0, -kKeyMove}, KeyMove{Qt::Key_Up, 0, kKeyMove}};

const KeyMove* moveOf(const QKeyEvent& event) {
  if (!event.modifiers().testFlag(Qt::AltModifier)) return nullptr;
  const auto* move = std::ranges::find(kKeyMoves, event.key(), &KeyMove::key);
  return move == kKeyMoves.end() ? nullptr : move;
}

double milliseconds(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

}  // namespace

ChartWidget::ChartWidget(QWidget* parent)
    : QWidget(parent),
      m_scene(std::make_unique<QGraphicsScene>()),
      m_chart(new QChart),
      m_plot(new ChartPlot(m_chart)),
      m_theme(Theme::of(palette())) {
  m_scene->addItem(m_chart);
  m_plot->setLeastTime(kLeastTime);
  m_plot->setMostPoints(kMostPoints);
  m_catchUp.setSingleShot(true);
  connect(&m_catchUp, &QTimer::timeout, this, &ChartWidget::refresh);
  const int share = screen()->size().height() / 4;
  setMinimumSize(kLeastWidth, std::clamp(share, kLeastHeight, kUsualHeight));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  applyLook();
}

ChartWidget::~ChartWidget() = default;

void ChartWidget::setSubject(const ChartKind& kind, ChartSubject subject) {
  m_plot->setSubject(kind, std::move(subject));
  m_overlay.readTime.reset();
  setAccessibleName(kind.tip());
  setAccessibleDescription(
      tr("A click goes to a moment. Wheel, plus and minus zoom, dragging a box does, too; Alt and "
         "the arrow keys move the chart, 0 shows all of it."));
  markChanged();
}

void ChartWidget::refresh() {
  if (!isVisible() || m_catchUp.isActive() || !m_plot->hasNews()) return;
  const double pause = std::max(kShortestPause, kPausePerWork * (m_updateTime + m_paintTime));
  const double waited = m_sinceDrawn.isValid() ? milliseconds(m_sinceDrawn) : pause;
  if (waited < pause) {
    m_catchUp.start(static_cast<int>(std::ceil(pause - waited)));
  } else {
    draw();
  }
}

void ChartWidget::draw() {
  QElapsedTimer work;
  work.start();
  m_plot->update();
  m_updateTime = milliseconds(work);
  markChanged();
}

void ChartWidget::markChanged() {
  m_pictureIsCurrent = false;
  m_sinceDrawn.start();
  update();
}

void ChartWidget::showTime(double time) {
  if (m_overlay.shownTime == time) return;
  m_overlay.shownTime = time;
  update();
}

QRectF ChartWidget::plotArea() const {
  return m_chart->plotArea();
}

ChartPicture ChartWidget::picture() const {
  return {&m_plot->kind(), m_plot->subject(), m_plot->hidden(), m_plot->zoom()};
}

void ChartWidget::setHidden(HiddenCurves hidden) {
  m_plot->setHidden(std::move(hidden));
  markChanged();
}

void ChartWidget::zoomIn() {
  zoomAt(plotArea().center(), kKeyFactor, kKeyFactor);
}

void ChartWidget::zoomOut() {
  zoomAt(plotArea().center(), 1 / kKeyFactor, 1 / kKeyFactor);
}

void ChartWidget::resetZoom() {
  m_plot->setZoom(std::nullopt);
  markChanged();
}

void ChartWidget::copyPicture() const {
  QGuiApplication::clipboard()->setImage(chartImage(picture(), {}));
}

void ChartWidget::copyData() {
  if (m_plot->hasNews()) draw();
  auto* table = new QMimeData;
  table->setText(chartTable(*m_plot, '\t', QLocale().decimalPoint()));
  table->setData(QStringLiteral("text/csv"),
                 chartTable(*m_plot, ',', QStringLiteral(".")).toUtf8());
  QGuiApplication::clipboard()->setMimeData(table);
}

void ChartWidget::applyLook() {
  m_theme = Theme::of(palette());
  m_plot->setLook(ChartLook::forScreen(m_theme, font()));
  markChanged();
}

/// Shows just this range, or all where that is no more.
void ChartWidget::zoomTo(const QRectF& range) {
  if (!canBeShown(range)) return;
  const bool isAll = range.contains(m_plot->wholeRange());
  m_plot->setZoom(isAll ? std::nullopt : std::optional(range));
  markChanged();
}

void ChartWidget::zoomAt(QPointF place, double factorX, double factorY) {
  zoomTo(zoomedAbout(m_plot->range(), valuesAt(place), factorX, factorY));
}

QPointF ChartWidget::valuesAt(QPointF place) const {
  return plotTransform(m_plot->range(), plotArea()).inverted().map(place);
}

/// The moment a place stands for: that of the time axis, or of the nearest point.
std::optional<double> ChartWidget::timeAt(QPointF place) const {
  const QPointF values = valuesAt(place);
  if (m_plot->content().overTime) return std::max(0.0, values.x());
  const QSizeF unit(plotArea().width() / m_plot->range().width(),
                    plotArea().height() / m_plot->range().height());
  return nearestTime(*m_plot, values, unit, kReadDistance);
}

bool ChartWidget::isOnTimeLine(QPointF place) const {
  if (!m_overlay.shownTime || !m_plot->content().overTime) return false;
  const QTransform toPlot = plotTransform(m_plot->range(), plotArea());
  const double x = toPlot.map(QPointF(*m_overlay.shownTime, 0)).x();
  const QRectF grip = plotArea().adjusted(0, -2 * kGrabDistance, 0, 0);
  return std::abs(place.x() - x) <= kGrabDistance && grip.top() <= place.y() &&
         place.y() <= grip.bottom();
}

void ChartWidget::toggleEntryAt(QPointF place) {
  const HeadingEntry* entry = m_plot->entryAt(place);
  if (entry == nullptr) return;
  HiddenCurves hidden = m_plot->hidden();
  const auto toggle = [](auto& set, const auto& key) {
    if (set.erase(key) == 0) set.insert(key);
  };
  if (entry->key.isEmpty()) {
    toggle(hidden.runs, entry->run);
  } else {
    toggle(hidden.names, entry->key);
  }
  setHidden(std::move(hidden));
}

void ChartWidget::pickAt(QPointF place) {
  if (const auto time = timeAt(place)) emit timePicked(*time);
}

void ChartWidget::readAt(QPointF place) {
  m_overlay.pointer = place;
  m_overlay.readTime = plotArea().contains(place) ? timeAt(place) : std::nullopt;
  update();
}

void ChartWidget::updatePointer(QPointF place) {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (isOnTimeLine(place)) {
    shape = Qt::SplitHCursor;
  } else if (m_plot->entryAt(place) != nullptr) {
    shape = Qt::PointingHandCursor;
  } else if (plotArea().contains(place)) {
    shape = Qt::CrossCursor;
  }
  if (cursor().shape() != shape) setCursor(shape);
}

void ChartWidget::finishBox() {
  const QRectF box = m_overlay.box.intersected(plotArea());
  m_overlay.box = {};
  update();
  if (box.width() < kClickDistance || box.height() < kClickDistance) return;
  const QRectF range = QRectF(valuesAt(box.topLeft()), valuesAt(box.bottomRight())).normalized();
  zoomTo(range);
}

void ChartWidget::mousePressEvent(QMouseEvent* event) {
  const QPointF place = event->position();
  const bool moves = event->button() == Qt::MiddleButton ||
                     (event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier);
  m_dragStart = place;
  m_rangeAtStart = m_plot->range();
  if (moves && plotArea().contains(place)) {
    m_drag = Drag::kMove;
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() != Qt::LeftButton) {
    QWidget::mousePressEvent(event);
  } else if (isOnTimeLine(place)) {
    m_drag = Drag::kTime;
  } else if (plotArea().contains(place)) {
    m_drag = Drag::kBox;
  } else {
    toggleEntryAt(place);
  }
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF place = event->position();
  const QPointF way = place - m_dragStart;
  switch (m_drag) {
    case Drag::kNone:
      readAt(place);
      updatePointer(place);
      break;
    case Drag::kTime:
      m_overlay.readTime.reset();
      pickAt(place);
      break;
    case Drag::kBox:
      m_overlay.readTime.reset();
      m_overlay.box = QRectF(m_dragStart, place).normalized().intersected(plotArea());
      update();
      break;
    case Drag::kMove:
      zoomTo(movedBy(m_rangeAtStart, -way.x() / plotArea().width(), way.y() / plotArea().height()));
      break;
  }
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
  const QPointF place = event->position();
  const Drag drag = std::exchange(m_drag, Drag::kNone);
  const bool isClick = (place - m_dragStart).manhattanLength() < kClickDistance;
  if (drag == Drag::kBox && isClick) pickAt(place);
  if (drag == Drag::kBox) finishBox();
  updatePointer(place);
}

void ChartWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && plotArea().contains(event->position())) resetZoom();
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
  const QPointF place = event->position();
  const double factor = std::pow(kWheelFactor, event->angleDelta().y() / 120.0);
  // Beside an axis only along it.
  const bool alongX = place.x() >= plotArea().left() && !(event->modifiers() & Qt::ControlModifier);
  const bool alongY = place.y() <= plotArea().bottom() && !(event->modifiers() & Qt::ShiftModifier);
  zoomAt(place, alongX ? factor : 1, alongY ? factor : 1);
  event->accept();
}

void ChartWidget::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  m_overlay.readTime.reset();
  update();
}

void ChartWidget::contextMenuEvent(QContextMenuEvent* event) {
  const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
  emit menuRequested(byKey ? mapToGlobal(rect().center()) : event->globalPos());
}

bool ChartWidget::wantsKey(const QKeyEvent& event) const {
  if (event.matches(QKeySequence::Copy) || moveOf(event) != nullptr) return true;
  if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return false;
  switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_0:
      return true;
    case Qt::Key_Escape:
      return m_plot->zoom().has_value();
    default:
      return false;
  }
}

void ChartWidget::keyPressEvent(QKeyEvent* event) {
  if (!wantsKey(*event)) {
    QWidget::keyPressEvent(event);
  } else if (event->matches(QKeySequence::Copy)) {
    copyPicture();
  } else if (const KeyMove* move = moveOf(*event)) {
    zoomTo(movedBy(m_plot->range(), move->x, move->y));
  } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Equal) {
    zoomIn();
  } else if (event->key() == Qt::Key_Minus) {
    zoomOut();
  } else {
    resetZoom();
  }
}

bool ChartWidget::event(QEvent* event) {
  // While the chart has the focus its keys come before the window's.
  if (event->type() == QEvent::ShortcutOverride && wantsKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void ChartWidget::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  switch (event->type()) {
    case QEvent::FontChange:
    case QEvent::LanguageChange:
    case QEvent::PaletteChange:
      applyLook();
      break;
    default:
      break;
  }
}

void ChartWidget::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (m_plot->hasNews()) draw();
}

void ChartWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_chart->resize(size());  // which updates the plot
  markChanged();
}

void ChartWidget::renderPicture() {
  QElapsedTimer work;
  work.start();
  m_chart->resize(size());
  m_chart->layout()->activate();
  m_picture = QPixmap(size() * devicePixelRatioF());
  m_picture.setDevicePixelRatio(devicePixelRatioF());
  m_picture.fill(m_theme.background);
  QPainter painter(&m_picture);
  painter.setRenderHint(QPainter::Antialiasing);
  m_scene->render(&painter, QRectF(rect()), QRectF(rect()));
  m_pictureIsCurrent = true;
  m_paintTime = milliseconds(work);
}

void ChartWidget::paintEvent(QPaintEvent*) {
  if (!m_pictureIsCurrent || m_picture.devicePixelRatio() != devicePixelRatioF()) renderPicture();
  QPainter painter(this);
  painter.drawPixmap(0, 0, m_picture);
  painter.setFont(ChartLook::forScreen(m_theme, font()).font);
  paintOverlay(painter, m_overlay, *m_plot, plotArea(), m_theme);
  if (hasFocus()) paintFocus(painter);
}

void ChartWidget::paintFocus(QPainter& painter) const {
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusWidth));
  painter.setBrush(Qt::NoBrush);
  const double inset = kFocusWidth / 2;
  painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
}

void ChartWidget::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void ChartWidget::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace ui
