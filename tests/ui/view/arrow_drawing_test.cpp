#include "ui/view/arrow_drawing.h"

#include <cmath>

#include <QLocale>
#include <QTest>

#include "core/motion/forces.h"
#include "tests/ui/view/example_scenes.h"

using Eigen::Vector2d;

namespace {

/// A weight of 2 kg on a rope of 1 m that hangs down at 3 m/s in air, pulled by 30 N.
ui::ShownScene swinging() {
  ui::ShownScene shown = example::hangingWeight(core::Phase::kTethered);
  shown.scene.airDensity = 50;
  core::Weight& weight = shown.scene.weights[0];
  weight.mass = 2;
  weight.radius = 0.1;
  core::WeightState& state = shown.runs[0].weights[0];
  state.velocity = {3, 0};
  state.tension = 30;
  return shown;
}

ui::Drawing drawn(const ui::ShownScene& shown) {
  return ui::sceneDrawing(shown, ui::Trails(), example::camera(shown), example::look());
}

/// From start to tip in pixels, y up.
std::vector<Vector2d> arrowsFrom(const Vector2d& place, QColor color, const ui::Drawing& drawing,
                                 const ui::Camera& camera) {
  std::vector<Vector2d> ways;
  for (const ui::Arrow& arrow : drawing.layers[ui::kFrontLayer].arrows)
    if (arrow.from == place && arrow.color == color.rgb())
      ways.emplace_back(camera.scale() * (arrow.to - arrow.from));
  return ways;
}

QStringList words(const ui::Drawing& drawing) {
  QStringList all;
  for (const ui::Text& text : drawing.texts) all << text.words;
  return all;
}

bool isAbout(const std::vector<Vector2d>& ways, const Vector2d& expected) {
  return ways.size() == 1 && (ways[0] - expected).norm() < 1e-6;  // px: rounding
}

}  // namespace

class ArrowDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void drawsNothingUnlessWanted();
  void velocitiesAreToTheStatedScale();
  void forcesAreToTheStatedScale();
  void aRodThatPushesDoesSoAwayFromItsPivot();
  void tellsTheValuesOfTheSelectedWeight();
  void writesTensionsAtTheRopes();
  void numbersDoNotLieOnEachOther();
  void inCrowdsOnlyTheSelectedWeightHasANumber();
  void inLargeCrowdsOnlyTheSelectedWeightHasArrows();
  void theRoomMakesPlaceForTheLegend();
};

void ArrowDrawingTest::drawsNothingUnlessWanted() {
  const ui::Drawing drawing = drawn(swinging());
  QVERIFY(drawing.layers[ui::kFrontLayer].arrows.empty());
  QVERIFY(words(drawing).filter("N").isEmpty());
}

void ArrowDrawingTest::velocitiesAreToTheStatedScale() {
  ui::ShownScene shown = swinging();
  shown.marks.arrows.velocities = true;
  shown.marks.arrows.scales.speed = 2;
  const ui::Drawing drawing = drawn(shown);
  const ui::Camera camera = example::camera(shown);
  // 3 m/s at 60 px for 2 m/s
  QVERIFY(isAbout(arrowsFrom({2, 1.5}, example::look().theme.kinetic, drawing, camera), {90, 0}));
  QVERIFY(words(drawing).contains("= 2 m/s"));
  QCOMPARE(words(drawing).filter(" N"), QStringList());
  // The arrow before those words is the one they mean.
  const auto isReference = [&](const ui::Arrow& arrow) {
    return std::abs(camera.scale() * (arrow.to - arrow.from).norm() - 60) < 1e-6;
  };
  const auto& arrows = drawing.layers[ui::kFrontLayer].arrows;
  QCOMPARE(std::count_if(arrows.begin(), arrows.end(), isReference), 1);
}

void ArrowDrawingTest::forcesAreToTheStatedScale() {
  ui::ShownScene shown = swinging();
  shown.marks.arrows.forces = true;
  shown.marks.arrows.scales.force = 20;
  const ui::Drawing drawing = drawn(shown);
  const ui::Camera camera = example::camera(shown);
  const ui::Theme theme = example::look().theme;
  const Vector2d place(2, 1.5);
  // 3 px for 1 N: 2 kg weigh 19.62 N, the rope pulls up with 30 N.
  QVERIFY(isAbout(arrowsFrom(place, theme.potential, drawing, camera), {0, -58.86}));
  QVERIFY(isAbout(arrowsFrom(place, theme.lostToRopes, drawing, camera), {0, 90}));
  const Vector2d drag = core::dragOn(shown.scene.weights[0], 50, {3, 0});
  QVERIFY(isAbout(arrowsFrom(place, theme.lostToAir, drawing, camera), 3 * drag));
  QVERIFY(drag.x() < -1);  // long enough to be drawn
  QVERIFY(words(drawing).contains("= 20 N"));
}

void ArrowDrawingTest::aRodThatPushesDoesSoAwayFromItsPivot() {
  ui::ShownScene shown = swinging();
  shown.scene.weights[0].rope->rigid = true;
  shown.runs[0].weights[0].tension = -30;
  shown.marks.arrows.forces = true;
  shown.marks.arrows.scales.force = 20;
  QVERIFY(isAbout(
      arrowsFrom({2, 1.5}, example::look().theme.lostToRopes, drawn(shown), example::camera(shown)),
      {0, -90}));
}

void ArrowDrawingTest::tellsTheValuesOfTheSelectedWeight() {
  ui::ShownScene shown = example::freeWeights(3, 0.05, 0);
  shown.marks.arrows.velocities = shown.marks.arrows.forces = true;
  shown.scene.weights[1].mass = 2;
  shown.runs[0].weights[1].velocity = {0.3, 0.4};
  QVERIFY(words(drawn(shown)).contains("gravity"));
  shown.marks.selection = ui::ShownSelection{1, false, {}};
  const QStringList described = words(drawn(shown));
  QVERIFY(described.contains("gravity 19.62 N"));
  QVERIFY(described.contains("velocity 0.50 m/s"));
  QVERIFY(described.contains("rope 0 N"));
}

void ArrowDrawingTest::writesTensionsAtTheRopes() {
  ui::ShownScene shown = swinging();
  shown.marks.arrows.tensions = true;
  QVERIFY(words(drawn(shown)).contains("30.00 N"));
  shown.runs[0].weights[0].phase = core::Phase::kSlack;
  shown.runs[0].weights[0].tension = 0;
  QVERIFY(words(drawn(shown)).contains("0 N"));
  shown.runs[0].weights[0].phase = core::Phase::kFlying;  // cut
  QCOMPARE(words(drawn(shown)).filter(" N"), QStringList());
}

void ArrowDrawingTest::numbersDoNotLieOnEachOther() {
  ui::ShownScene shown = example::freeWeights(2, 0.02, 0);
  for (int i = 0; i < 2; ++i) {
    shown.scene.weights[i].rope = core::Rope{{2 + 0.01 * i, 2.5}, 1, 0, 0, false};
    core::WeightState& state = shown.runs[0].weights[i];
    state.position = {2 + 0.01 * i, 1.5};
    state.phase = core::Phase::kTethered;
    state.tension = 1 + i;
  }
  shown.marks.arrows.tensions = true;
  QCOMPARE(words(drawn(shown)).filter(" N"), QStringList("1.00 N"));
  // The selected weight's comes before the others.
  shown.marks.selection = ui::ShownSelection{1, false, {}};
  QCOMPARE(words(drawn(shown)).filter(" N"), QStringList("2.00 N"));
}

void ArrowDrawingTest::inCrowdsOnlyTheSelectedWeightHasANumber() {
  ui::ShownScene shown = example::freeWeights(200, 0.001, 0);
  for (int i = 0; i < 200; ++i) {
    const double x = shown.scene.weights[i].position.x();
    shown.scene.weights[i].rope = core::Rope{{x, 2.5}, 1.5, 0, 0, false};
    shown.runs[0].weights[i].phase = core::Phase::kTethered;
    shown.runs[0].weights[i].tension = 1 + i;
  }
  shown.marks.arrows.tensions = true;
  QCOMPARE(words(drawn(shown)).filter(" N"), QStringList());
  shown.marks.selection = ui::ShownSelection{99, false, {}};
  QCOMPARE(words(drawn(shown)).filter(" N"), QStringList("100.0 N"));
}

void ArrowDrawingTest::inLargeCrowdsOnlyTheSelectedWeightHasArrows() {
  ui::ShownScene shown = example::freeWeights(5000, 0.001, 0);
  shown.marks.arrows.forces = true;
  const auto arrowsAtWeights = [&] {
    const ui::Drawing drawing = drawn(shown);
    const auto& arrows = drawing.layers[ui::kFrontLayer].arrows;
    return std::count_if(arrows.begin(), arrows.end(),
                         [](const ui::Arrow& arrow) { return arrow.from.y() == 1; });
  };
  QCOMPARE(arrowsAtWeights(), 0);
  QVERIFY(words(drawn(shown)).contains("at the selected weight only"));
  shown.marks.selection = ui::ShownSelection{4321, false, {}};
  QCOMPARE(arrowsAtWeights(), 1);
}

void ArrowDrawingTest::theRoomMakesPlaceForTheLegend() {
  ui::ShownScene shown = swinging();
  const double before = ui::sceneMargins(shown, example::look(), 800).top();
  shown.marks.arrows.forces = true;
  const double after = ui::sceneMargins(shown, example::look(), 800).top();
  QVERIFY(after >= before + ui::lineHeight(example::look().font));
  const ui::Camera camera = example::camera(shown);
  const double ceiling = camera.toPixels({0, 3}).y();
  const ui::Drawing drawing = drawn(shown);
  for (const ui::Text& text : drawing.texts)
    if (text.words.contains("gravity")) QVERIFY(camera.toPixels(text.at).y() + 16 < ceiling);
}

QTEST_MAIN(ArrowDrawingTest)
#include "arrow_drawing_test.moc"
