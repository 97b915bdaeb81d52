#include "ui/view/scene_view.h"

#include <cmath>
#include <optional>
#include <utility>

#include <QAccessible>
#include <QEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/view/opengl_probe.h"
#include "ui/view/scene_accessible.h"
#include "ui/view/scene_canvas.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/scene_mouse.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

namespace ui {

namespace {

constexpr double kZoomPerNotch = 1.15;
constexpr double kDegreesPerNotch = 15 * 8;  // as QWheelEvent counts

QSizeF roomSize(const ShownScene& shown) {
  return {shown.scene.room.width, shown.scene.room.height};
}

}  // namespace

class SceneView::Content {
 public:
  explicit Content(SceneView* view) : m_view(view) {
    readLook();
    chooseCanvas();
  }

  void setRuns(std::vector<const core::Run*> runs, std::size_t firstPlace) {
    const QSizeF before = roomSize(m_shown);
    m_runs = std::move(runs);
    ShownScene next = shownScene(m_runs, firstPlace);
    next.target.swap(m_shown.target);
    next.marks = std::move(m_shown.marks);
    m_shown = std::move(next);
    m_trails.reset(static_cast<int>(m_runs.size()), static_cast<int>(m_shown.colors.size()),
                   trailSpan(m_shown.scene));
    m_trails.record(m_shown.time, m_shown.runs);
    if (m_isFitted || roomSize(m_shown) != before) fit();
    repaint();
  }

  void showTime(double time) {
    if (m_openGlCanvas && m_openGlCanvas->isLost()) loseOpenGl();
    readWeights(m_runs, time, m_shown);
    m_trails.record(time, m_shown.runs);
    repaint();
  }

  void showStep(const ShownStep* step) {
    if (!step && !m_shown.step) return;
    m_shown.step.reset();
    if (step) m_shown.step = *step;
    repaint();
  }

  void setMarks(const SceneMarks& marks) {
    const QMarginsF before = margins();
    m_shown.marks = marks;
    if (m_isFitted && margins() != before) fit();
    repaint();
  }

  void setTarget(const std::optional<ShownTarget>& target) {
    if (!target && !m_shown.target) return;
    m_shown.target = target;
    repaint();
  }

  const ShownScene& shown() const { return m_shown; }
  const SceneLook& look() const { return m_look; }

  void clearTrails() {
    m_trails.clear();
    m_trails.record(m_shown.time, m_shown.runs);
    repaint();
  }

  void setTrailsShown(bool shown) {
    m_look.trails = shown;
    repaint();
  }

  const Trails* trails() const { return m_look.trails ? &m_trails : nullptr; }

  QString trailsDescription() const {
    if (!m_look.trails || !m_trails.isShortened()) return {};
    return m_trails.pointsEach() > 0 ? SceneView::tr("Trails shortened: many weights")
                                     : SceneView::tr("No trails: too many weights");
  }

  void setChoice(PainterChoice choice) {
    if (choice == m_choice) return;
    m_choice = choice;
    chooseCanvas();
    emit m_view->painterChanged();
  }

  QString painterDescription() const {
    if (m_openGlCanvas)
      return SceneView::tr("OpenGL %1 (%2)").arg(m_support->version, m_support->renderer);
    if (m_choice == PainterChoice::kQPainter) return SceneView::tr("QPainter");
    if (m_isOpenGlLost) return SceneView::tr("QPainter (OpenGL was lost)");
    if (!m_support->usable) return SceneView::tr("QPainter (no OpenGL 3.3)");
    return SceneView::tr("QPainter (software OpenGL would be slower)");
  }

  void fit() {
    m_isFitted = true;
    placeCamera();
    m_camera.fit(roomSize(m_shown), margins());
    repaint();
  }

  void resize() {
    m_canvas->setGeometry(m_view->rect());
    placeCamera();
    if (m_isFitted) fit();
  }

  const Camera& camera() const { return m_camera; }
  bool isFitted() const { return m_isFitted; }

  void follow(const Content& other) {
    m_isFitted = other.m_isFitted;
    m_camera = other.m_camera;
    placeCamera();
    repaint();
  }

  void zoomAt(QPointF pixel, double factor) {
    m_isFitted = false;
    m_camera.zoomAt(pixel, factor);
    showMoved();
  }

  void panBy(QPointF pixels) {
    m_isFitted = false;
    m_camera.panBy(pixels);
    showMoved();
  }

  void readLook() {
    m_look.theme = Theme::of(m_view->palette());
    m_look.font = readableFont(m_view->font());
    if (m_canvas) repaint();
  }

 private:
  void repaint() { m_canvas->update(); }

  QMarginsF margins() const { return sceneMargins(m_shown, m_look, m_view->width()); }

  void showMoved() {
    repaint();
    emit m_view->cameraMoved();
  }

  void placeCamera() {
    const QSizeF size(std::max(m_view->width(), 1), std::max(m_view->height(), 1));
    m_camera.setViewport(size, m_view->devicePixelRatioF());
  }

  Frame frame(QSize size, double devicePixelRatio) {
    m_camera.setViewport(size, devicePixelRatio);
    return {m_camera, sceneDrawing(m_shown, m_trails, m_camera, m_look)};
  }

  bool wantsOpenGl() {
    if (m_choice == PainterChoice::kQPainter) return false;
    if (!m_support) m_support = probeOpenGl();
    return m_support->usable && (m_choice == PainterChoice::kOpenGl || !m_support->software);
  }

  void chooseCanvas() {
    const bool openGl = wantsOpenGl();
    if (m_canvas && openGl == (m_openGlCanvas != nullptr)) return;
    // Later, because a canvas may be painting right now when it is found to be of no use.
    if (m_canvas) m_canvas->deleteLater();
    if (m_canvas) m_canvas->hide();
    const auto source = [this](QSize size, double ratio) { return frame(size, ratio); };
    m_openGlCanvas = openGl ? new OpenGlCanvas(source, m_view) : nullptr;
    m_canvas = m_openGlCanvas;
    if (!openGl) m_canvas = new PainterCanvas(source, m_view);
    if (openGl)
      connect(
          m_openGlCanvas, &OpenGlCanvas::failed, m_view, [this] { loseOpenGl(); },
          Qt::QueuedConnection);
    m_canvas->setGeometry(m_view->rect());
    m_canvas->setVisible(true);
  }

  void loseOpenGl() {
    m_support = OpenGlSupport();
    m_isOpenGlLost = true;
    chooseCanvas();
    emit m_view->painterChanged();
  }

  SceneView* m_view;
  // The one canvas there is, of either kind; owned by the view.
  QWidget* m_canvas = nullptr;
  OpenGlCanvas* m_openGlCanvas = nullptr;
  PainterChoice m_choice = PainterChoice::kAutomatic;
  std::optional<OpenGlSupport> m_support;
  bool m_isOpenGlLost = false;

  std::vector<const core::Run*> m_runs;
  ShownScene m_shown;
  Trails m_trails;
  SceneLook m_look;
  Camera m_camera;
  bool m_isFitted = true;
};

SceneView::SceneView(QWidget* parent)
    : QWidget(parent),
      m_content(std::make_unique<Content>(this)),
      m_mouse(std::make_unique<SceneMouse>(this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setMinimumSize(240, 140);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  installSceneAccessible();
  nameParts();
}

void SceneView::nameParts() {
  setAccessibleName(tr("Scene"));
  setAccessibleDescription(
      tr("The room with its weights and ropes. A click selects a weight, the wheel zooms, "
         "dragging moves the view."));
}

void SceneView::announce(const QString& words) {
  m_announcement = words;
  QAccessibleValueChangeEvent event(this, words);
  QAccessible::updateAccessibility(&event);
}

SceneView::~SceneView() = default;

void SceneView::setRuns(std::vector<const core::Run*> runs, std::size_t firstPlace) {
  m_content->setRuns(std::move(runs), firstPlace);
}
void SceneView::showTime(double time) {
  m_content->showTime(time);
}
void SceneView::showStep(const ShownStep* step) {
  m_content->showStep(step);
}
void SceneView::setMarks(const SceneMarks& marks) {
  m_content->setMarks(marks);
}
void SceneView::setHand(SceneHand* hand) {
  m_mouse->setHand(hand);
}
const ShownScene& SceneView::shown() const {
  return m_content->shown();
}
const SceneLook& SceneView::look() const {
  return m_content->look();
}
void SceneView::setTarget(const std::optional<ShownTarget>& target) {
  m_content->setTarget(target);
}
const ShownTarget* SceneView::target() const {
  const std::optional<ShownTarget>& target = m_content->shown().target;
  return target ? &*target : nullptr;
}
const core::Room& SceneView::room() const {
  return m_content->shown().scene.room;
}
void SceneView::clearTrails() {
  m_content->clearTrails();
}
void SceneView::setTrailsShown(bool shown) {
  m_content->setTrailsShown(shown);
}
QString SceneView::trailsDescription() const {
  return m_content->trailsDescription();
}
const Trails* SceneView::trails() const {
  return m_content->trails();
}
void SceneView::setPainterChoice(PainterChoice choice) {
  m_content->setChoice(choice);
}
QString SceneView::painterDescription() const {
  return m_content->painterDescription();
}
const Camera& SceneView::camera() const {
  return m_content->camera();
}
bool SceneView::isFitted() const {
  return m_content->isFitted();
}
void SceneView::follow(const SceneView& other) {
  m_content->follow(*other.m_content);
}
void SceneView::fitRoom() {
  m_content->fit();
  emit cameraMoved();
}

void SceneView::panBy(QPointF pixels) {
  m_content->panBy(pixels);
}

void SceneView::zoomIn() {
  m_content->zoomAt(QRectF(rect()).center(), std::pow(kZoomPerNotch, 2));
}

void SceneView::zoomOut() {
  m_content->zoomAt(QRectF(rect()).center(), std::pow(kZoomPerNotch, -2));
}

void SceneView::resizeEvent(QResizeEvent*) {
  m_content->resize();
}

void SceneView::changeEvent(QEvent* event) {
  const bool looksDifferent = event->type() == QEvent::PaletteChange ||
                              event->type() == QEvent::FontChange ||
                              event->type() == QEvent::LanguageChange;
  if (looksDifferent) m_content->readLook();
  if (event->type() == QEvent::LanguageChange) nameParts();
  QWidget::changeEvent(event);
}

void SceneView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / kDegreesPerNotch;
  m_content->zoomAt(event->position(), std::pow(kZoomPerNotch, notches));
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  m_mouse->press(*event);
}

void SceneView::mouseMoveEvent(QMouseEvent* event) {
  m_mouse->move(*event);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  m_mouse->release(*event);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && m_mouse->pressAgain(*event)) fitRoom();
}

}  // namespace ui
