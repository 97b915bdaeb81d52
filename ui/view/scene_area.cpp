#include "ui/view/scene_area.h"

#include <algorithm>
#include <utility>

#include "core/run/run.h"
#include "ui/view/camera.h"
#include "ui/view/target_handle.h"

namespace ui {

namespace {

constexpr int kGap = 2;  // between views [px]

/// Size of one of `count` cells that share a length evenly [px].
int cell(int length, int count) {
  return (length - (count - 1) * kGap) / count;
}

}  // namespace

SceneArea::SceneArea(QWidget* parent) : QWidget(parent) {
  addView();
  setMinimumSize(m_views.front()->minimumSize());
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SceneArea::setRuns(std::vector<const core::Run*> runs) {
  m_runs = std::move(runs);
  m_time = 0;
  distributeRuns();
}

void SceneArea::showTime(double time) {
  m_time = time;
  for (SceneView* view : m_views) view->showTime(time);
}

void SceneArea::showStep(const ShownStep* step, std::size_t run) {
  for (std::size_t i = 0; i < m_views.size(); ++i)
    m_views[i]->showStep(m_views.size() == 1 || i == run ? step : nullptr);
}

void SceneArea::setMarks(const SceneMarks& marks) {
  m_marks = marks;
  for (SceneView* view : m_views) view->setMarks(marks);
  followOne(m_views.front());
}

void SceneArea::setHand(SceneHand* hand) {
  m_hand = hand;
  for (SceneView* view : m_views) view->setHand(hand);
}

const Trails* SceneArea::trails() const {
  return m_views.size() == 1 ? m_views.front()->trails() : nullptr;
}

void SceneArea::setTarget(const std::optional<ShownTarget>& target) {
  m_target = target;
  distributeTarget();
}

/// Each view shows the landings of its own runs.
void SceneArea::distributeTarget() {
  for (std::size_t i = 0; i < m_views.size(); ++i) {
    std::optional<ShownTarget> target = m_target;
    const bool isOwn = m_views.size() > 1 && target && i < target->landings.size();
    if (isOwn) target->landings = {m_target->landings[i]};
    m_views[i]->setTarget(target);
  }
}

void SceneArea::setSplit(bool split) {
  if (split == m_split) return;
  m_split = split;
  distributeRuns();
  if (!m_runs.empty()) showTime(m_time);
}

void SceneArea::distributeRuns() {
  const bool split = m_split && m_runs.size() > 1;
  setViewCount(split ? m_runs.size() : 1);
  if (split) {
    for (std::size_t i = 0; i < m_runs.size(); ++i) m_views[i]->setRuns({m_runs[i]}, i);
  } else {
    m_views.front()->setRuns(m_runs);
  }
  distributeTarget();
  arrange();
  emit trailsChanged();
}

void SceneArea::setViewCount(std::size_t count) {
  while (m_views.size() < count) addView();
  while (m_views.size() > count) {
    delete m_views.back();
    m_views.pop_back();
  }
}

void SceneArea::addView() {
  auto* view = new SceneView(this);
  view->setPainterChoice(m_choice);
  view->setTrailsShown(m_trailsShown);
  view->setMarks(m_marks);
  view->setHand(m_hand);
  connect(view, &SceneView::painterChanged, this, &SceneArea::painterChanged);
  connect(view, &SceneView::cameraMoved, this, [this, view] { followOne(view); });
  connect(new TargetHandle(view), &TargetHandle::moved, this, &SceneArea::targetMoved);
  m_views.push_back(view);
  view->show();
}

void SceneArea::setPainterChoice(PainterChoice choice) {
  m_choice = choice;
  for (SceneView* view : m_views) view->setPainterChoice(choice);
}

void SceneArea::setTrailsShown(bool shown) {
  m_trailsShown = shown;
  for (SceneView* view : m_views) view->setTrailsShown(shown);
  emit trailsChanged();
}

void SceneArea::resizeEvent(QResizeEvent*) {
  arrange();
}

/// All of one size to the pixel, so that the same camera shows the same in each.
void SceneArea::arrange() {
  const core::Room room = m_runs.empty() ? core::Room() : m_runs.front()->scene().room;
  const int columns = columnsFor(QSizeF(room.width, room.height));
  const int rows = (static_cast<int>(m_views.size()) + columns - 1) / columns;
  const QSize size(cell(width(), columns), cell(height(), rows));
  for (int i = 0; i < static_cast<int>(m_views.size()); ++i) {
    const QPoint corner(i % columns * (size.width() + kGap), i / columns * (size.height() + kGap));
    m_views[i]->setGeometry(QRect(corner, size));
  }
  followOne(m_views.front());
}

/// All see what one sees; or where it shows the whole room, what the one with the highest title
/// sees, so that no title lies over its room.
void SceneArea::followOne(const SceneView* leader) {
  const auto middle = [](const SceneView* view) {
    return view->camera().toMetres(QRectF(view->rect()).center()).y();
  };
  if (leader->isFitted())
    for (const SceneView* view : m_views)
      if (view->isFitted() && middle(view) > middle(leader)) leader = view;
  for (SceneView* view : m_views)
    if (view != leader) view->follow(*leader);
}

int SceneArea::columnsFor(QSizeF room) const {
  const int count = static_cast<int>(m_views.size());
  int best = 1;
  double largest = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double scale =
        std::min(cell(width(), columns) / room.width(), cell(height(), rows) / room.height());
    if (scale <= largest) continue;
    largest = scale;
    best = columns;
  }
  return best;
}

}  // namespace ui
