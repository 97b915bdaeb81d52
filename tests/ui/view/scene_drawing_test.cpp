#include "ui/view/scene_drawing.h"

#include <QFontMetricsF>
#include <QTest>

#include "tests/ui/view/example_scenes.h"
#include "ui/view/room_drawing.h"
#include "ui/view/weight_drawing.h"

using core::Phase;

class SceneDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void numbersNeverOverlapWallsOrOtherWords_data();
  void numbersNeverOverlapWallsOrOtherWords();
  void numbersStandWhereTheySay();
  void firstRunIsFilledTheOthersAreOutlines();
  void joinsWeightsThatPartVisibly_data();
  void joinsWeightsThatPartVisibly();
  void drawsWeightsInTheirTrueSize();
  void neverDrawsWeightsTooSmallToSee();
  void drawsTheRopesThatStillHold_data();
  void drawsTheRopesThatStillHold();
  void drawsRodsThickerThanRopes();
  void slackRopesHang();
  void trailsFadeAndCanBeHidden();
  void legendNamesEveryRun();
  void legendKeepsClearOfTheScaleInItsFirstRowAlone();
  void legendBreaksNamesTooLongForThePicture();
  void drawsAStepEnlargedAboutItsAnchor();
  void textIsLargeEnoughToRead();

 private:
  static ui::Drawing drawingOf(const ui::ShownScene& shown) {
    return ui::sceneDrawing(shown, ui::Trails(), example::camera(shown), example::look());
  }

  static QRectF boxOf(const ui::Text& text, const ui::Camera& camera) {
    const QFontMetricsF metrics(text.font);
    return {camera.toPixels(text.at) + text.offset,
            QSizeF(metrics.horizontalAdvance(text.words), metrics.height())};
  }
};

void SceneDrawingTest::numbersNeverOverlapWallsOrOtherWords_data() {
  QTest::addColumn<QSizeF>("room");
  QTest::addColumn<QSizeF>("viewport");
  QTest::addColumn<double>("zoom");
  const QList<QSizeF> rooms{{4, 3}, {0.01, 0.01}, {1e5, 1e5}, {1e5, 0.01}, {0.07, 900}, {7.3, 1.1}};
  for (const QSizeF& room : rooms)
    for (const QSizeF& viewport : {QSizeF(1280, 720), QSizeF(240, 180)})
      for (const double zoom : {0.3, 1.0, 2.7, 40.0, 1e4})
        QTest::addRow("%g x %g m, %g px wide, zoom %g", room.width(), room.height(),
                      viewport.width(), zoom)
            << room << viewport << zoom;
}

void SceneDrawingTest::numbersNeverOverlapWallsOrOtherWords() {
  QFETCH(QSizeF, room);
  QFETCH(QSizeF, viewport);
  QFETCH(double, zoom);
  ui::ShownScene shown = example::freeWeights(0, 0.02, 0);
  shown.scene.room.width = room.width();
  shown.scene.room.height = room.height();
  ui::Camera camera = example::camera(shown, viewport);
  // Near the lower left corner, where both rows of numbers meet.
  camera.zoomAt(camera.toPixels({room.width() / 10, room.height() / 10}), zoom);
  const ui::Drawing drawing = ui::sceneDrawing(shown, ui::Trails(), camera, example::look());

  // The names of both runs come last, and the scale bar's length where there is room for it.
  const ui::RoomFrame frame = ui::roomFrame(shown.scene.room, camera);
  const std::size_t otherWords = viewport.width() > 1000 ? 3 : 2;
  QVERIFY(drawing.texts.size() >= otherWords);
  for (std::size_t i = 0; i + otherWords < drawing.texts.size(); ++i) {
    const QRectF box = boxOf(drawing.texts[i], camera);
    QVERIFY(QRectF(QPointF(0, 0), viewport).contains(box));
    for (const QRectF& wall : {frame.floor, frame.ceiling, frame.west, frame.east})
      QVERIFY(!box.intersects(wall));
    for (std::size_t j = i + 1; j < drawing.texts.size(); ++j)
      QVERIFY2(!box.intersects(boxOf(drawing.texts[j], camera)),
               qPrintable(drawing.texts[i].words + " and " + drawing.texts[j].words));
  }
  // A picture of usual size always has some numbers.
  if (viewport.width() > 1000) QVERIFY(drawing.texts.size() >= 3 + otherWords);
}

void SceneDrawingTest::numbersStandWhereTheySay() {
  const ui::ShownScene shown = example::freeWeights(1, 0.02, 0);
  const ui::Camera camera = example::camera(shown);
  const ui::Ruler ruler = ui::roomRuler(shown.scene.room, camera, example::look());
  const ui::Drawing drawing = drawingOf(shown);
  bool found = false;
  for (const ui::Text& text : drawing.texts) {
    const QRectF box = boxOf(text, camera);
    const QPointF place = camera.toPixels({1, 0});
    if (text.words != ruler.textAt(1) || box.top() < place.y()) continue;
    found = true;
    QVERIFY(std::abs(box.center().x() - place.x()) < 1);
  }
  QVERIFY(found);
}

void SceneDrawingTest::firstRunIsFilledTheOthersAreOutlines() {
  const ui::ShownScene shown = example::freeWeights(3, 0.02, 0.5);
  const std::vector<ui::Disc> discs = drawingOf(shown).layers[ui::kWeightLayer].discs;
  QCOMPARE(discs.size(), std::size_t(6));
  for (int i = 0; i < 3; ++i) {
    QCOMPARE(discs[i].fill, shown.colors[i]);
    QCOMPARE(discs[i].center, shown.runs[0].weights[i].position);
    QCOMPARE(qAlpha(discs[3 + i].fill), 0);
    QCOMPARE(discs[3 + i].outline, ui::Theme::light().runs[1].rgb());
    QCOMPARE(discs[3 + i].center, shown.runs[1].weights[i].position);
  }
}

void SceneDrawingTest::joinsWeightsThatPartVisibly_data() {
  QTest::addColumn<double>("apart");
  QTest::addColumn<int>("lines");
  QTest::newRow("together") << 0.0 << 0;
  QTest::newRow("within the outline") << 0.015 << 0;
  QTest::newRow("just clear of it") << 0.05 << 3;
  QTest::newRow("apart") << 0.5 << 3;
}

void SceneDrawingTest::joinsWeightsThatPartVisibly() {
  QFETCH(double, apart);
  QFETCH(int, lines);
  const ui::Drawing drawing = drawingOf(example::freeWeights(3, 0.02, apart));
  QCOMPARE(static_cast<int>(drawing.layers[ui::kWeightLayer].lines.size()), lines);
}

void SceneDrawingTest::drawsWeightsInTheirTrueSize() {
  const ui::ShownScene shown = example::freeWeights(2, 0.15, 0);
  QVERIFY(!ui::enlargesWeights(shown, example::camera(shown)));
  const ui::Drawing drawing = drawingOf(shown);
  for (const ui::Disc& disc : drawing.layers[ui::kWeightLayer].discs) QCOMPARE(disc.radius, 0.15);
}

void SceneDrawingTest::neverDrawsWeightsTooSmallToSee() {
  const ui::ShownScene shown = example::freeWeights(2, 1e-4, 0);
  const ui::Camera camera = example::camera(shown);
  QVERIFY(ui::enlargesWeights(shown, camera));
  const ui::Drawing drawing = drawingOf(shown);
  for (const ui::Disc& disc : drawing.layers[ui::kWeightLayer].discs)
    QCOMPARE(disc.radius * camera.scale(), ui::kLeastRadius);
}

void SceneDrawingTest::drawsTheRopesThatStillHold_data() {
  QTest::addColumn<int>("phase");
  QTest::addColumn<int>("lines");
  QTest::addColumn<int>("polylines");
  QTest::newRow("taut") << int(Phase::kTethered) << 1 << 0;
  QTest::newRow("slack") << int(Phase::kSlack) << 0 << 1;
  QTest::newRow("cut") << int(Phase::kFlying) << 0 << 0;
  QTest::newRow("at rest") << int(Phase::kResting) << 0 << 0;
}

void SceneDrawingTest::drawsTheRopesThatStillHold() {
  QFETCH(int, phase);
  QFETCH(int, lines);
  QFETCH(int, polylines);
  const ui::Drawing drawing = drawingOf(example::hangingWeight(static_cast<Phase>(phase)));
  const ui::Layer& layer = drawing.layers[ui::kRopeLayer];
  QCOMPARE(static_cast<int>(layer.lines.size()), lines);
  QCOMPARE(static_cast<int>(layer.polylines.size()), polylines);
  QCOMPARE(layer.discs.size(), std::size_t(1));  // the pivot stays
}

void SceneDrawingTest::drawsRodsThickerThanRopes() {
  const auto width = [](bool rigid) {
    const ui::Drawing drawing = drawingOf(example::hangingWeight(Phase::kTethered, rigid));
    return drawing.layers[ui::kRopeLayer].lines.at(0).width;
  };
  QVERIFY(width(true) > 1.5 * width(false));
}

void SceneDrawingTest::slackRopesHang() {
  ui::ShownScene shown = example::hangingWeight(Phase::kSlack);
  shown.runs[0].weights[0].position = {2.4, 2.4};
  const ui::Drawing drawing = drawingOf(shown);
  double lowest = 3;
  for (const Eigen::Vector2d& point : drawing.layers[ui::kRopeLayer].polylines.at(0).points)
    lowest = std::min(lowest, point.y());
  QVERIFY(lowest < 2.2);
}

void SceneDrawingTest::trailsFadeAndCanBeHidden() {
  ui::Trails trails;
  const ui::ShownScene shown = example::everything(trails);
  ui::SceneLook look = example::look();
  const ui::Camera camera = example::camera(shown);
  const auto shownTrails = [&] {
    return ui::sceneDrawing(shown, trails, camera, look).layers[ui::kTrailLayer].polylines;
  };
  QCOMPARE(shownTrails().size(), std::size_t(14));
  for (const ui::Polyline& trail : shownTrails()) QVERIFY(trail.fading);
  look.trails = false;
  QCOMPARE(shownTrails().size(), std::size_t(0));
}

void SceneDrawingTest::legendNamesEveryRun() {
  QStringList words;
  for (const ui::Text& text : drawingOf(example::freeWeights(1, 0.02, 0)).texts)
    words << text.words;
  QVERIFY(words.contains("first method"));
  QVERIFY(words.contains("second method"));
}

void SceneDrawingTest::legendKeepsClearOfTheScaleInItsFirstRowAlone() {
  ui::ShownScene shown = example::freeWeights(1, 0.02, 0);
  const QStringList names = {"Runge–Kutta 4, 1/60 s", "Euler (semi-implicit), 1/60 s",
                             "Dormand–Prince 5(4), tolerance 1e-6"};
  shown.runs.resize(2, shown.runs.front());
  shown.runs.push_back(shown.runs.back());
  for (qsizetype i = 0; i < names.size(); ++i)
    shown.runs[static_cast<std::size_t>(i)].name = names[i];
  const ui::Camera camera = example::camera(shown, {800, 600});
  std::vector<QPointF> places;
  for (const ui::Text& text : ui::sceneDrawing(shown, ui::Trails(), camera, example::look()).texts)
    if (names.contains(text.words)) places.push_back(camera.toPixels(text.at) + text.offset);
  QCOMPARE(places.size(), std::size_t(3));
  QVERIFY(places[1].y() > places[0].y());
  QCOMPARE(places[2].y(), places[1].y());
}

void SceneDrawingTest::legendBreaksNamesTooLongForThePicture() {
  ui::ShownScene shown = example::freeWeights(1, 0.02, 0);
  shown.runs.pop_back();
  shown.runs[0].name = "Euler (semi-implicit), 1/60 s";
  const auto wordsIn = [&](QSizeF size) {
    QStringList words;
    const ui::Camera camera = example::camera(shown, size);
    for (const ui::Text& text :
         ui::sceneDrawing(shown, ui::Trails(), camera, example::look()).texts)
      words << text.words;
    return words;
  };
  QVERIFY(wordsIn({800, 600}).contains("Euler (semi-implicit), 1/60 s"));
  QVERIFY(wordsIn({240, 180}).contains("Euler (semi-implicit),"));
  QVERIFY(wordsIn({240, 180}).contains("1/60 s"));
}

void SceneDrawingTest::drawsAStepEnlargedAboutItsAnchor() {
  ui::ShownScene shown = example::freeWeights(1, 0.02, 0);
  ui::ShownStep step;
  step.anchor = step.end = {2, 1};
  step.start = {1.99, 1};
  step.slopes = {{"k1", {1.99, 1}, {0.01, 0}}, {"k2", {1.995, 1}, {0.01, 0}}};
  shown.step = step;
  const ui::Camera camera = example::camera(shown);
  const double enlargement = ui::enlargementOf(step, camera);
  // So that an arrow of 1 cm is 36 to 90 pixels long.
  QVERIFY(enlargement == 20 || enlargement == 50);
  const std::vector<ui::Arrow> arrows =
      ui::sceneDrawing(shown, ui::Trails(), camera, example::look()).layers[ui::kFrontLayer].arrows;
  QCOMPARE(arrows.size(), std::size_t(2));
  const auto isAt = [](const Eigen::Vector2d& place, double x) {
    return (place - Eigen::Vector2d(x, 1)).norm() < 1e-12;
  };
  QVERIFY(isAt(arrows[0].from, 2 - 0.01 * enlargement));
  QVERIFY(isAt(arrows[0].to, 2));
  QVERIFY(isAt(arrows[1].to, 2 + 0.005 * enlargement));
}

void SceneDrawingTest::textIsLargeEnoughToRead() {
  QFont tiny("DejaVu Sans");
  tiny.setPixelSize(7);
  QVERIFY(ui::readableFont(tiny).pixelSize() >= 16);  // 12 pt at 96 dpi
}

QTEST_MAIN(SceneDrawingTest)
#include "scene_drawing_test.moc"
