#include "ui/view/arrow_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/motion/forces.h"
#include "ui/view/camera.h"
#include "ui/view/drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/shown_scene.h"
#include "ui/view/words_beside.h"

namespace ui {

namespace {

constexpr double kLeastArrow = 2;   // shorter ones would be all head [px]
constexpr double kMostArrow = 1e4;  // longer ones end far outside of any picture [px]
constexpr double kEdge = 10;        // left and right of the legend [px]
constexpr double kEntryGap = 18;    // between its entries [px]
constexpr double kNameArrow = 24;   // before a name [px]
constexpr double kWordsGap = 6;     // between arrow and name [px]
constexpr double kNumberGap = 6;    // between a rope and its number [px]
constexpr std::size_t kMany = 100;  // with more weights than these arrows are thinner
constexpr std::size_t kMostNumbers = 16;
constexpr std::size_t kMostWithArrows = 1000;  // more would be a thicket that takes long to draw

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneView)
};

/// A vector at a weight, in pixels with y up.
struct PixelVector {
  Eigen::Vector2d way;
  QRgb color;
};

/// Short enough for what grows while it is looked at.
QString value(double number, const QString& unit) {
  const double size = std::abs(number);
  if (size > 0 && (size < 1e-3 || size >= 1e5))
    return QLocale().toString(number, 'e', 1) + ' ' + unit;
  const int decimals = size == 0 || size >= 1000 ? 0 : size >= 100 ? 1 : size >= 0.1 ? 2 : 3;
  return QLocale().toString(number, 'f', decimals) + ' ' + unit;
}

/// Index of the selected weight; beyond all weights: none.
std::size_t selectedIn(const ShownScene& shown) {
  if (!shown.marks.selection) return shown.scene.weights.size();
  return static_cast<std::size_t>(shown.marks.selection->weight);
}

/// The selected weight, or the only one; null: neither.
const core::WeightState* describedState(const ShownScene& shown, std::size_t& index) {
  if (shown.runs.empty()) return nullptr;
  const std::vector<core::WeightState>& weights = shown.runs[0].weights;
  index = weights.size() == 1 ? 0 : selectedIn(shown);
  return index < weights.size() ? &weights[index] : nullptr;
}

Eigen::Vector2d tensionAt(const core::Weight& weight, const core::WeightState& state) {
  if (!weight.rope || state.tension == 0) return {0, 0};
  return core::tensionOn(weight.rope->pivot, state.position, state.tension);
}

/// One entry of the legend: an arrow of this length and color, and words.
struct Entry {
  double arrow;  // [px]
  QColor color;
  QString words;
  double width;  // [px]
  QPointF corner = QPointF();
};

/// The longest that words with a value get, so that nothing moves while the value does.
double widestWords(const QString& name, const QString& unit, const SceneLook& look) {
  return widthOf(name + QStringLiteral(" 00.00 ") + unit, look.font);
}

class Legend {
 public:
  Legend(const ShownScene& shown, const SceneLook& look, double width)
      : m_shown(shown), m_look(look), m_state(describedState(shown, m_index)) {
    addScale();
    if (shown.marks.arrows.velocities) addVelocity();
    if (shown.marks.arrows.forces) addForces();
    if (!m_entries.empty() && shown.scene.weights.size() > kMostWithArrows) addNote();
    placeEntries(width);
  }

  const std::vector<Entry>& entries() const { return m_entries; }
  /// [px]
  double height() const {
    return m_entries.empty() ? 0 : m_entries.back().corner.y() + lineHeight(m_look.font);
  }

 private:
  void add(double arrow, const QColor& color, const QString& words, double wordsWidth) {
    m_entries.push_back({arrow, color, words, arrow + kWordsGap + wordsWidth});
  }

  /// What the arrow that leads the legend stands for.
  void addScale() {
    const ShownArrows& arrows = m_shown.marks.arrows;
    QStringList amounts;
    if (arrows.velocities) amounts << QLocale().toString(arrows.scales.speed, 'g', 6) + " m/s";
    if (arrows.forces) amounts << QLocale().toString(arrows.scales.force, 'g', 6) + " N";
    if (amounts.isEmpty()) return;
    const QString words = "= " + amounts.join(" = ");
    add(kReferenceLength, m_look.theme.text, words, widthOf(words, m_look.font));
  }

  void addNamed(const QString& name, double number, const QString& unit, const QColor& color) {
    const QString words = m_state ? name + ' ' + value(number, unit) : name;
    const double width = m_state ? widestWords(name, unit, m_look) : widthOf(name, m_look.font);
    add(kNameArrow, color, words, width);
  }

  void addNote() {
    const QString words = Words::tr("at the selected weight only");
    m_entries.push_back({0, m_look.theme.text, words, widthOf(words, m_look.font)});
  }

  void addVelocity() {
    const QColor& color = m_look.theme.kinetic;
    addNamed(Words::tr("velocity"), m_state ? m_state->velocity.norm() : 0, QStringLiteral("m/s"),
             color);
  }

  void addForces() {
    const QString unit = QStringLiteral("N");
    const Theme& theme = m_look.theme;
    const core::Scene& scene = m_shown.scene;
    double gravity = 0, drag = 0;
    if (m_state) {
      const core::Weight& weight = scene.weights[m_index];
      gravity = core::gravityOn(weight, scene.gravity).norm();
      drag = core::dragOn(weight, scene.airDensity, m_state->velocity).norm();
    }
    addNamed(Words::tr("gravity"), gravity, unit, theme.potential);
    addNamed(Words::tr("air"), drag, unit, theme.lostToAir);
    addNamed(Words::tr("rope"), m_state ? m_state->tension : 0, unit, theme.lostToRopes);
  }

  void placeEntries(double width) {
    QPointF next(kEdge, 0);
    for (Entry& entry : m_entries) {
      if (next.x() > kEdge && next.x() + entry.width > width - kEdge)
        next = QPointF(kEdge, next.y() + lineHeight(m_look.font));
      entry.corner = next;
      next.rx() += entry.width + kEntryGap;
    }
  }

  const ShownScene& m_shown;
  const SceneLook& m_look;
  std::size_t m_index = 0;
  const core::WeightState* m_state;
  std::vector<Entry> m_entries;
};

void addArrow(const Eigen::Vector2d& place, const PixelVector& vector, double width,
              const Camera& camera, Layer& layer) {
  const double length = vector.way.norm();
  if (!(length >= kLeastArrow)) return;
  const double share = std::min(1.0, kMostArrow / length);
  layer.arrows.push_back({place, place + share / camera.scale() * vector.way, width, vector.color});
}

void addArrowsOf(const ShownScene& shown, std::size_t index, double width, const Camera& camera,
                 const SceneLook& look, Layer& layer) {
  const core::Weight& weight = shown.scene.weights[index];
  const core::WeightState& state = shown.runs[0].weights[index];
  const ShownArrows& arrows = shown.marks.arrows;
  const double perForce = arrows.forces ? arrows.scales.pixelsPerForce() : 0;
  const double perSpeed = arrows.velocities ? arrows.scales.pixelsPerSpeed() : 0;
  std::array<PixelVector, 4> vectors{
      {{perSpeed * state.velocity, look.theme.kinetic.rgb()},
       {perForce * core::gravityOn(weight, shown.scene.gravity), look.theme.potential.rgb()},
       {perForce * tensionAt(weight, state), look.theme.lostToRopes.rgb()},
       {perForce * core::dragOn(weight, shown.scene.airDensity, state.velocity),
        look.theme.lostToAir.rgb()}}};
  // Of arrows that lie on each other the shorter ones are seen.
  std::ranges::stable_sort(vectors, std::ranges::greater(),
                           [](const PixelVector& vector) { return vector.way.squaredNorm(); });
  for (const PixelVector& vector : vectors) addArrow(state.position, vector, width, camera, layer);
}

/// Puts the tensions of ropes beside their middles where no other one stands yet.
class TensionNumbers {
 public:
  TensionNumbers(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                 Drawing& drawing)
      : m_shown(shown), m_camera(camera), m_look(look), m_drawing(drawing) {}

  void add(std::size_t index) {
    const core::Weight& weight = m_shown.scene.weights[index];
    const core::WeightState& state = m_shown.runs[0].weights[index];
    const bool isTied = state.phase == core::Phase::kTethered || state.phase == core::Phase::kSlack;
    if (!weight.rope || !isTied) return;
    const QString words = value(state.tension, QStringLiteral("N"));
    const QSizeF size(widthOf(words, m_look.font), lineHeight(m_look.font));
    const QPointF corner = cornerBeside(m_camera.toPixels(weight.rope->pivot),
                                        m_camera.toPixels(state.position), size, kNumberGap);
    const QRectF box(corner, size);
    if (std::ranges::any_of(m_taken, [&](const QRectF& other) { return other.intersects(box); }))
      return;
    m_taken.push_back(box);
    m_drawing.texts.push_back({m_camera.toMetres(corner), QPointF(0, 0), words, m_look.font,
                               m_look.theme.lostToRopes.rgb(),
                               withOpacity(m_look.theme.room, 0.85)});
  }

 private:
  const ShownScene& m_shown;
  const Camera& m_camera;
  const SceneLook& m_look;
  Drawing& m_drawing;
  std::vector<QRectF> m_taken;
};

/// The selected weight's comes first; in crowds no other one.
void drawTensions(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                  Drawing& drawing) {
  TensionNumbers numbers(shown, camera, look, drawing);
  const std::size_t count = shown.runs[0].weights.size();
  const std::size_t selected = selectedIn(shown);
  if (selected < count) numbers.add(selected);
  if (count > kMostNumbers) return;
  for (std::size_t i = 0; i < count; ++i)
    if (i != selected) numbers.add(i);
}

}  // namespace

double arrowLegendHeight(const ShownScene& shown, const SceneLook& look, double width) {
  return Legend(shown, look, width).height();
}

void drawArrowLegend(const ShownScene& shown, double top, const Camera& camera,
                     const SceneLook& look, Drawing& drawing) {
  const Legend legend(shown, look, camera.viewport().width());
  for (const Entry& entry : legend.entries()) {
    const QPointF corner = entry.corner + QPointF(0, top);
    const QPointF from = corner + QPointF(0, lineHeight(look.font) / 2);
    if (entry.arrow > 0)
      drawing.layers[kFrontLayer].arrows.push_back({camera.toMetres(from),
                                                    camera.toMetres(from + QPointF(entry.arrow, 0)),
                                                    3, entry.color.rgb()});
    const QPointF words = corner + QPointF(entry.arrow > 0 ? entry.arrow + kWordsGap : 0, 0);
    drawing.texts.push_back({camera.toMetres(words), QPointF(0, 0), entry.words, look.font,
                             look.theme.text.rgb(), withOpacity(look.theme.background, 0.85)});
  }
}

void drawArrows(const ShownScene& shown, const Camera& camera, const SceneLook& look,
                Drawing& drawing) {
  if (shown.runs.empty()) return;
  const ShownArrows& arrows = shown.marks.arrows;
  const std::size_t count = shown.runs[0].weights.size();
  const double width = count > kMany ? 1.5 : 3;
  Layer& layer = drawing.layers[kFrontLayer];
  if (arrows.velocities || arrows.forces) {
    if (count <= kMostWithArrows)
      for (std::size_t i = 0; i < count; ++i) addArrowsOf(shown, i, width, camera, look, layer);
    else if (const std::size_t selected = selectedIn(shown); selected < count)
      addArrowsOf(shown, selected, 2 * width, camera, look, layer);
  }
  if (arrows.tensions) drawTensions(shown, camera, look, drawing);
}

}  // namespace ui
