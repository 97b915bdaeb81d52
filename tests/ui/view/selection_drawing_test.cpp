#include "ui/view/selection_drawing.h"

#include <QTest>

#include "tests/ui/view/example_scenes.h"

namespace {

/// Twelve weights beside each other, closer than a label is wide, with this one selected.
ui::ShownScene row(int selected, bool standsStill) {
  ui::ShownScene shown = example::freeWeights(12, 0.05, 0);
  ui::ShownSelection selection;
  selection.weight = selected;
  selection.isMovable = standsStill;
  selection.words = QStringList{"Weight 6", "30°"};
  shown.marks.selection = selection;
  return shown;
}

/// Where the words stand [px].
QRectF placeOfWords(const ui::ShownScene& shown, const ui::Camera& camera,
                    const ui::SceneLook& look) {
  ui::Drawing drawing;
  ui::drawSelection(shown, camera, look, drawing);
  QRectF place;
  for (const ui::Text& text : drawing.texts)
    place |= QRectF(camera.toPixels(text.at),
                    QSizeF(ui::widthOf(text.words, look.font), ui::lineHeight(look.font)));
  return place;
}

int coveredBy(const QRectF& words, const ui::ShownScene& shown, const ui::Camera& camera) {
  int covered = 0;
  for (const core::WeightState& weight : shown.runs[0].weights)
    covered += words.contains(camera.toPixels(weight.position)) ? 1 : 0;
  return covered;
}

}  // namespace

class SelectionDrawingTest : public QObject {
  Q_OBJECT

 private slots:
  void wordsCoverNoWeightThatStandsStill();
  void wordsStayAtOneSideOfAWeightThatMoves();
  void wordsStayInThePicture_data();
  void wordsStayInThePicture();
};

void SelectionDrawingTest::wordsCoverNoWeightThatStandsStill() {
  for (int selected = 0; selected < 12; ++selected) {
    const ui::ShownScene shown = row(selected, true);
    const ui::Camera camera = example::camera(shown);
    QCOMPARE(coveredBy(placeOfWords(shown, camera, example::look()), shown, camera), 0);
  }
}

void SelectionDrawingTest::wordsStayAtOneSideOfAWeightThatMoves() {
  ui::ShownScene shown = row(5, false);
  const ui::Camera camera = example::camera(shown);
  const auto beside = [&] {
    return placeOfWords(shown, camera, example::look()).topLeft() -
           camera.toPixels(shown.runs[0].weights[5].position);
  };
  const QPointF before = beside();
  for (int i = 6; i < 12; ++i) shown.runs[0].weights[i].position.y() = 2;
  QVERIFY((beside() - before).manhattanLength() < 1e-9);
}

void SelectionDrawingTest::wordsStayInThePicture_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("y");
  for (const double x : {0.05, 2.0, 3.95})
    for (const double y : {0.05, 1.5, 2.95}) QTest::addRow("%g, %g", x, y) << x << y;
}

void SelectionDrawingTest::wordsStayInThePicture() {
  QFETCH(double, x);
  QFETCH(double, y);
  for (const bool standsStill : {true, false}) {
    ui::ShownScene shown = row(5, standsStill);
    shown.runs[0].weights[5].position = {x, y};
    const ui::Camera camera = example::camera(shown);
    const QRectF words = placeOfWords(shown, camera, example::look());
    QVERIFY(QRectF(QPointF(0, 0), camera.viewport()).contains(words));
  }
}

QTEST_MAIN(SelectionDrawingTest)
#include "selection_drawing_test.moc"
