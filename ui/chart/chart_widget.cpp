#include "ui/chart/chart_widget.h"

#include <algorithm>
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

#include "ui/chart/chart_hand.h"
#include "ui/chart/chart_table.h"

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

double milliseconds(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

}  // namespace

ChartWidget::ChartWidget(QWidget* parent)
    : QWidget(parent),
      m_scene(std::make_unique<QGraphicsScene>()),
      m_chart(new QChart),
      m_plot(new ChartPlot(m_chart)),
      m_hand(new ChartHand(m_chart, m_plot, this)),
      m_theme(Theme::of(palette())) {
  m_scene->addItem(m_chart);
  m_plot->setLeastTime(kLeastTime);
  m_plot->setMostPoints(kMostPoints);
  m_catchUp.setSingleShot(true);
  connect(&m_catchUp, &QTimer::timeout, this, &ChartWidget::refresh);
  connect(m_hand, &ChartHand::plotChanged, this, &ChartWidget::markChanged);
  connect(m_hand, &ChartHand::overlayChanged, this, qOverload<>(&QWidget::update));
  connect(m_hand, &ChartHand::cursorWanted, this, &ChartWidget::showCursor);
  connect(m_hand, &ChartHand::timePicked, this, &ChartWidget::timePicked);
  const int share = screen()->size().height() / 4;
  setMinimumSize(kLeastWidth, std::clamp(share, kLeastHeight, kUsualHeight));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  applyLook();
}

ChartWidget::~ChartWidget() = default;

void ChartWidget::setSubject(const ChartKind& kind, ChartSubject subject) {
  m_plot->setSubject(kind, std::move(subject));
  m_hand->stopReading();
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
  m_hand->showTime(time);
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
  m_hand->zoomIn();
}

void ChartWidget::zoomOut() {
  m_hand->zoomOut();
}

void ChartWidget::resetZoom() {
  m_hand->resetZoom();
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

void ChartWidget::mousePressEvent(QMouseEvent* event) {
  if (!m_hand->press(*event)) QWidget::mousePressEvent(event);
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
  m_hand->move(*event);
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
  m_hand->release(*event);
}

void ChartWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  m_hand->pressAgain(*event);
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
  m_hand->turnWheel(*event);
  event->accept();
}

void ChartWidget::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  m_hand->stopReading();
}

void ChartWidget::contextMenuEvent(QContextMenuEvent* event) {
  const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
  emit menuRequested(byKey ? mapToGlobal(rect().center()) : event->globalPos());
}

void ChartWidget::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copyPicture();
  } else if (m_hand->wants(*event)) {
    m_hand->pressKey(*event);
  } else {
    QWidget::keyPressEvent(event);
  }
}

bool ChartWidget::event(QEvent* event) {
  // While the chart has the focus its keys come before the window's.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.matches(QKeySequence::Copy) || m_hand->wants(key)) {
      event->accept();
      return true;
    }
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
  paintOverlay(painter, m_hand->overlay(), *m_plot, plotArea(), m_theme);
  if (hasFocus()) paintFocus(painter);
}

void ChartWidget::paintFocus(QPainter& painter) const {
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusWidth));
  painter.setBrush(Qt::NoBrush);
  const double inset = kFocusWidth / 2;
  painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
}

void ChartWidget::showCursor(Qt::CursorShape shape) {
  if (cursor().shape() != shape) setCursor(shape);
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
