#include "ui/control/weight_mover.h"

#include <cmath>
#include <utility>

#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/selection.h"
#include "ui/control/weight_drag.h"
#include "ui/view/camera.h"
#include "ui/view/picking.h"
#include "ui/view/scene_view.h"
#include "ui/view/shown_scene.h"

namespace ui {

namespace {

QPointF placeOf(WeightMover::Grip grip, const core::Weight& weight, const ArrowScales& scales,
                const Camera& camera) {
  return grip == WeightMover::Grip::kVelocity ? velocityGrip(weight, scales, camera)
                                              : camera.toPixels(core::startPosition(weight));
}

}  // namespace

WeightMover::WeightMover(SceneEditor* editor, const Selection* selection,
                         const RunController* controller, QObject* parent)
    : QObject(parent), m_editor(editor), m_selection(selection), m_controller(controller) {}

bool WeightMover::isAllowed() const {
  return m_controller->time() == 0 && !m_controller->isPlaying() && !m_controller->isTravelling();
}

const core::Weight* WeightMover::weight() const {
  const auto selected = static_cast<std::size_t>(m_selection->weight().value_or(-1));
  const std::vector<core::Weight>& weights = m_editor->draft().weights;
  return selected < weights.size() ? &weights[selected] : nullptr;
}

std::optional<WeightMover::Grip> WeightMover::gripAt(const SceneView& view, QPointF pixel) const {
  const core::Weight* selected = weight();
  if (!selected || !isAllowed()) return std::nullopt;
  const ArrowScales& scales = view.shown().marks.arrows.scales;
  const QPointF away = pixel - velocityGrip(*selected, scales, view.camera());
  if (std::hypot(away.x(), away.y()) <= kPickReach) return Grip::kVelocity;
  const bool isOnBody =
      isNear(core::startPosition(*selected), selected->radius, view.camera(), pixel);
  return isOnBody ? std::optional(Grip::kBody) : std::nullopt;
}

void WeightMover::begin(Grip grip, const SceneView& view, QPointF pixel) {
  const core::Weight& selected = *weight();
  const ArrowScales& scales = view.shown().marks.arrows.scales;
  // A velocity that is zero is led by its tip from the first move on.
  const bool isLedByTip = grip == Grip::kVelocity && core::startVelocity(selected).norm() == 0;
  const QPointF offset =
      isLedByTip ? QPointF() : placeOf(grip, selected, scales, view.camera()) - pixel;
  m_held = Held{grip, *m_selection->weight(), selected, offset, scales};
  say({});
}

void WeightMover::drag(const SceneView& view, QPointF pixel, Qt::KeyboardModifiers modifiers) {
  if (!m_held || m_selection->weight() != m_held->weight) return;
  const Camera& camera = view.camera();
  const Eigen::Vector2d place = camera.toMetres(pixel + m_held->offset);
  const double perSpeed = m_held->scales.pixelsPerSpeed();
  const HandFineness fineness{1 / camera.scale(), 1 / perSpeed,
                              modifiers.testFlag(Qt::ControlModifier),
                              handSteps(m_editor->draft().room)};
  const bool setsLength = modifiers.testFlag(Qt::ShiftModifier);
  const QString key = QStringLiteral("drag");
  if (m_held->grip == Grip::kVelocity) {
    change(
        [&](core::Weight& weight) {
          const Eigen::Vector2d way = camera.scale() * (place - core::startPosition(weight));
          dragVelocity(weight, way / perSpeed, fineness);
        },
        [] { return tr("change of velocity"); }, key);
    say({velocityWords(*weight())});
  } else if (!weight()->rope) {
    change([&](core::Weight& weight) { dragPosition(weight, place, fineness); },
           [] { return tr("move of a weight"); }, key);
    say({positionWords(*weight())});
  } else if (setsLength) {
    change([&](core::Weight& weight) { dragLength(*weight.rope, place, fineness); },
           [] { return tr("move of a weight"); }, key);
    say({lengthWords(*weight()->rope)});
  } else {
    change([&](core::Weight& weight) { dragAngle(*weight.rope, place, fineness); },
           [] { return tr("move of a weight"); }, key);
    say({angleWords(*weight()->rope)});
  }
}

void WeightMover::end() {
  if (!m_held) return;
  m_held.reset();
  m_editor->closeStep();
  emit changed();
}

void WeightMover::cancel() {
  if (!m_held) return;
  const core::Weight before = m_held->before;
  if (m_selection->weight() == m_held->weight)
    change([&](core::Weight& weight) { weight = before; }, [] { return tr("move of a weight"); },
           QStringLiteral("drag"));
  m_words.clear();
  end();
}

void WeightMover::moveBy(double x, double y) {
  if (!weight()) return;
  const HandSteps steps = handSteps(m_editor->draft().room);
  change(
      [&](core::Weight& weight) {
        nudge(weight, {x, y}, steps);
      },
      [] { return tr("move of a weight"); },
      x != 0 ? QStringLiteral("move aside") : QStringLiteral("move upwards"));
  const core::Weight& moved = *weight();
  say({!moved.rope ? positionWords(moved)
       : x != 0    ? angleWords(*moved.rope)
                   : lengthWords(*moved.rope)});
}

void WeightMover::accelerateBy(double x, double y) {
  if (!weight()) return;
  const HandSteps steps = handSteps(m_editor->draft().room);
  change(
      [&](core::Weight& weight) {
        nudgeVelocity(weight, {x, y}, steps);
      },
      [] { return tr("change of velocity"); }, QStringLiteral("velocity"));
  say({velocityWords(*weight())});
}

void WeightMover::forgetWords() {
  if (m_words.isEmpty()) return;
  m_words.clear();
  emit changed();
}

void WeightMover::change(const Edit& edit, const Words& words, const QString& mergeKey) {
  const auto index = static_cast<std::size_t>(*m_selection->weight());
  m_editor->change([&](core::Scene& scene) { edit(scene.weights[index]); }, words,
                   mergeKey + QString::number(index));
}

void WeightMover::say(const QStringList& words) {
  m_words = words + problems();
  emit changed();
}

/// Why the weight cannot start there, as short as a hand needs it.
QStringList WeightMover::problems() const {
  if (m_editor->problems().empty()) return {};
  switch (m_editor->problems().front().kind) {
    case core::Problem::Kind::kOverlap:
      return {tr("overlaps another weight")};
    case core::Problem::Kind::kOutsideRoom:
      return {tr("outside the room")};
    default:
      return {tr("not possible")};
  }
}

}  // namespace ui
