#include <cmath>
#include <numbers>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLocale>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QWheelEvent>

#include "core/scene/arrangement.h"
#include "core/trade/reference.h"
#include "tests/support/fields.h"
#include "ui/control/scene_editor.h"
#include "ui/control/translations.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/runs_form.h"
#include "ui/panels/scene_form.h"
#include "ui/panels/weight_columns.h"
#include "ui/panels/weights_form.h"
#include "ui/panels/weights_model.h"

using tests::enter;
using tests::fieldNamed;
using ui::Language;
using ui::QuantityField;
using ui::WeightColumn;

namespace {

core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.solvers = {core::Solver{.method = "rk4"}, core::Solver{.method = "euler"}};
  return scene;
}

QString shown(const QWidget& form, const QString& name) {
  return fieldNamed(form, name)->spinBox()->text();
}

}  // namespace

class FormsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QLocale::setDefault(QLocale::c()); }
  void cleanup() { ui::speak(Language::kEnglish); }
  void aFieldChangesTheScene_data();
  void aFieldChangesTheScene();
  void theNumberOfWeightsHangsThemEvenly();
  void aValueTheSceneCannotTakeIsMarkedAtItsField();
  void escapeTakesBackAValueTheSceneCannotTake();
  void anotherSceneVoidsWhatWasTyped();
  void theCutIsByHandOrByTheClock();
  void oneWeightChangesAlone();
  void allWeightsChangeAtOnce();
  void differentWeightsShowNoCommonValue();
  void fieldsWithoutAWeightCannotBeEdited();
  void explainsAWeightAsTheTableDoes_data();
  void explainsAWeightAsTheTableDoes();
  void methodAndStepOfARunChange();
  void anAdaptiveMethodTakesAToleranceInPlaceOfAStep();
  void theSecondRunGoesAndComesBackAsItWas();
  void upToFourRunsTheReferenceAmongThem();
  void adaptiveMethodsTakeATolerance();
  void theWheelPassesOverValuesWithoutChangingThem();
};

void FormsTest::aFieldChangesTheScene_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("text");
  QTest::addColumn<double>("value");
  QTest::newRow("gravity") << "Gravity"
                           << "1.62" << 1.62;
  QTest::newRow("air density") << "Air density"
                               << "0" << 0.0;
  QTest::newRow("width") << "Width"
                         << "5" << 5.0;
  QTest::newRow("height") << "Height"
                          << "4" << 4.0;
  QTest::newRow("restitution of walls") << "Restitution of walls"
                                        << "0.5" << 0.5;
  QTest::newRow("friction") << "Friction of walls"
                            << "0.25" << 0.25;
  QTest::newRow("restitution of weights") << "Restitution of weights"
                                          << "0.75" << 0.75;
}

void FormsTest::aFieldChangesTheScene() {
  QFETCH(QString, name);
  QFETCH(QString, text);
  QFETCH(double, value);
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  enter(fieldNamed(form, name), text);
  const core::Scene& scene = *editor.scene();
  const QHash<QString, double> values{{"Gravity", scene.gravity},
                                      {"Air density", scene.airDensity},
                                      {"Width", scene.room.width},
                                      {"Height", scene.room.height},
                                      {"Restitution of walls", scene.room.restitution},
                                      {"Friction of walls", scene.room.friction},
                                      {"Restitution of weights", scene.restitution}};
  QCOMPARE(values[name], value);
}

void FormsTest::theNumberOfWeightsHangsThemEvenly() {
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  enter(fieldNamed(form, "Weights"), "7");
  QCOMPARE(editor.scene()->weights.size(), std::size_t{7});
  const auto pivot = [&](int i) { return editor.scene()->weights[i].rope->pivot.x(); };
  const double interval = pivot(1) - pivot(0);
  // A sum of intervals, so only as exact as its rounding.
  for (int i = 2; i < 7; ++i) QVERIFY(std::abs(pivot(i) - pivot(i - 1) - interval) < 1e-12);
}

void FormsTest::aValueTheSceneCannotTakeIsMarkedAtItsField() {
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  enter(fieldNamed(form, "Width"), "0.5");
  QVERIFY(fieldNamed(form, "Width")->reason().contains("outside the room"));
  QCOMPARE(shown(form, "Width"), QString("0.5 m"));
  QCOMPARE(editor.scene()->room.width, threeWeights().room.width);

  enter(fieldNamed(form, "Weights"), "1");
  QVERIFY(!fieldNamed(form, "Width")->isMarked());
  QCOMPARE(editor.scene()->room.width, 0.5);
}

void FormsTest::escapeTakesBackAValueTheSceneCannotTake() {
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  enter(fieldNamed(form, "Width"), "0.5");
  QTest::keyClick(fieldNamed(form, "Width")->spinBox(), Qt::Key_Escape);
  QCOMPARE(shown(form, "Width"), QString("4 m"));
  QVERIFY(!fieldNamed(form, "Width")->isMarked());
  QVERIFY(editor.problems().empty());
}

void FormsTest::anotherSceneVoidsWhatWasTyped() {
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  enter(fieldNamed(form, "Gravity"), "-1");
  editor.replace(threeWeights());
  QCOMPARE(shown(form, "Gravity"), QString("9.81 m/s²"));
  QVERIFY(!fieldNamed(form, "Gravity")->isMarked());
}

void FormsTest::theCutIsByHandOrByTheClock() {
  ui::SceneEditor editor(threeWeights());
  ui::SceneForm form(&editor);
  QuantityField* time = fieldNamed(form, "Time of the cut");
  QVERIFY(!time->isEnabled());
  form.findChild<QCheckBox*>()->click();
  QVERIFY(time->isEnabled());
  enter(time, "0.9");
  QCOMPARE(editor.scene()->cutTime, std::optional(0.9));
  form.findChild<QCheckBox*>()->click();
  QVERIFY(!editor.scene()->cutTime.has_value());
}

void FormsTest::oneWeightChangesAlone() {
  ui::SceneEditor editor(threeWeights());
  ui::WeightsForm form(&editor);
  form.choose(2);
  enter(fieldNamed(form, "Start angle"), "30");
  enter(fieldNamed(form, "Mass"), "0.5");
  QCOMPARE(editor.scene()->weights[1].rope->angle, std::numbers::pi / 6);
  QCOMPARE(editor.scene()->weights[1].mass, 0.5);
  QCOMPARE(editor.scene()->weights[0].rope->angle, 0.0);
  QCOMPARE(editor.scene()->weights[2].mass, 0.19);
}

void FormsTest::allWeightsChangeAtOnce() {
  ui::SceneEditor editor(threeWeights());
  ui::WeightsForm form(&editor);
  enter(fieldNamed(form, "Length"), "0.8");
  enter(fieldNamed(form, "Radius"), "0.03");
  enter(fieldNamed(form, "Drag coefficient"), "1");
  for (const core::Weight& weight : editor.scene()->weights) {
    QCOMPARE(weight.rope->length, 0.8);
    QCOMPARE(weight.radius, 0.03);
    QCOMPARE(weight.dragCoefficient, 1.0);
  }
}

void FormsTest::differentWeightsShowNoCommonValue() {
  ui::SceneEditor editor(threeWeights());
  ui::WeightsForm form(&editor);
  form.choose(2);
  enter(fieldNamed(form, "Mass"), "0.5");
  form.choose(0);
  QCOMPARE(shown(form, "Mass"), QString());
  QCOMPARE(shown(form, "Radius"), QString("0.02 m"));
}

void FormsTest::fieldsWithoutAWeightCannotBeEdited() {
  core::Scene scene = threeWeights();
  scene.weights[0].rope.reset();
  scene.weights[0].position = {1, 1};
  ui::SceneEditor editor(scene);
  ui::WeightsForm form(&editor);
  form.choose(1);
  QVERIFY(!fieldNamed(form, "Length")->isEnabled());
  QVERIFY(fieldNamed(form, "Mass")->isEnabled());
  editor.change([](core::Scene& draft) { draft.weights.clear(); });
  QVERIFY(!fieldNamed(form, "Mass")->isEnabled());
}

void FormsTest::explainsAWeightAsTheTableDoes_data() {
  QTest::addColumn<Language>("language");
  QTest::addColumn<QString>("mass");
  QTest::newRow("English") << Language::kEnglish << "Mass m";
  QTest::newRow("Swedish") << Language::kSwedish << "Massan m";
  QTest::newRow("French") << Language::kFrench << "Masse m";
}

void FormsTest::explainsAWeightAsTheTableDoes() {
  QFETCH(Language, language);
  QFETCH(QString, mass);
  ui::speak(language);
  ui::SceneEditor editor(threeWeights());
  const ui::WeightsForm form(&editor);
  const ui::WeightsModel table(&editor);
  const auto heading = [&](WeightColumn column) {
    return table.headerData(static_cast<int>(column), Qt::Horizontal, Qt::ToolTipRole).toString();
  };
  QVERIFY2(heading(WeightColumn::kMass).startsWith(mass), qPrintable(heading(WeightColumn::kMass)));
  QStringList tips;
  for (const QuantityField* field : form.findChildren<QuantityField*>())
    tips << field->spinBox()->toolTip();
  QCOMPARE(tips, QStringList({heading(WeightColumn::kLength), heading(WeightColumn::kAngle),
                              heading(WeightColumn::kMass), heading(WeightColumn::kRadius),
                              heading(WeightColumn::kDragCoefficient)}));
}

void FormsTest::methodAndStepOfARunChange() {
  ui::SceneEditor editor(threeWeights());
  ui::RunsForm form(&editor);
  enter(fieldNamed(form, "Step of run 2"), "1/240");
  QCOMPARE(editor.scene()->solvers[1].step, 1.0 / 240);
  auto* method = form.findChildren<QComboBox*>().at(0);
  QCOMPARE(method->currentData().toString(), QString("rk4"));
  QTest::keyClick(method, Qt::Key_Home);
  QCOMPARE(editor.scene()->solvers[0].method, std::string("euler"));
}

void FormsTest::anAdaptiveMethodTakesAToleranceInPlaceOfAStep() {
  ui::SceneEditor editor(threeWeights());
  ui::RunsForm form(&editor);
  enter(fieldNamed(form, "Step of run 1"), "1/240");
  QVERIFY(fieldNamed(form, "Tolerance of run 1")->isHidden());
  QTest::keyClick(form.findChildren<QComboBox*>().at(0), Qt::Key_End);
  QCOMPARE(editor.scene()->solvers[0].method, std::string("dopri5"));
  QCOMPARE(editor.scene()->solvers[0].step, core::Solver().step);
  QVERIFY(fieldNamed(form, "Step of run 1")->isHidden());
  QVERIFY(!fieldNamed(form, "Step of run 2")->isHidden());
  enter(fieldNamed(form, "Tolerance of run 1"), "1e-6");
  QCOMPARE(editor.scene()->solvers[0].tolerance, 1e-6);
}

void FormsTest::theSecondRunGoesAndComesBackAsItWas() {
  ui::SceneEditor editor(threeWeights());
  ui::RunsForm form(&editor);
  enter(fieldNamed(form, "Step of run 2"), "1/240");
  auto* second = form.findChildren<QCheckBox*>().at(1);
  second->click();
  QCOMPARE(editor.scene()->solvers.size(), std::size_t{1});
  QVERIFY(!fieldNamed(form, "Step of run 2")->isEnabled());
  second->click();
  QCOMPARE(editor.scene()->solvers.size(), std::size_t{2});
  QCOMPARE(editor.scene()->solvers[1].step, 1.0 / 240);
  QCOMPARE(editor.scene()->solvers[1].method, std::string("euler"));
}

void FormsTest::upToFourRunsTheReferenceAmongThem() {
  ui::SceneEditor editor(threeWeights());
  const ui::RunsForm form(&editor);
  const auto shownOf = [&](const QString& name) {
    for (QCheckBox* box : form.findChildren<QCheckBox*>())
      if (box->accessibleName() == name) return box;
    qFatal("no run named %s", qPrintable(name));
  };
  QVERIFY(!shownOf("Run 4")->isEnabled());  // one after the other
  shownOf("Run 3")->click();
  QCOMPARE(editor.scene()->solvers[2].method, std::string("semi-implicit-euler"));
  shownOf("Run 4")->click();
  QVERIFY(core::isReference(editor.scene()->solvers[3]));
  QVERIFY(!fieldNamed(form, "Step of run 4")->isEnabled());
}

void FormsTest::adaptiveMethodsTakeATolerance() {
  core::Scene scene = threeWeights();
  scene.solvers[0] = {.method = "dopri5", .tolerance = 1e-6};
  ui::SceneEditor editor(scene);
  const ui::RunsForm form(&editor);
  QVERIFY(fieldNamed(form, "Step of run 1")->isHidden());
  QVERIFY(!fieldNamed(form, "Tolerance of run 1")->isHidden());
  QVERIFY(fieldNamed(form, "Tolerance of run 2")->isHidden());
  QCOMPARE(shown(form, "Tolerance of run 1"), QString("1e-6"));
  enter(fieldNamed(form, "Tolerance of run 1"), "1e-8");
  QCOMPARE(editor.scene()->solvers[0].tolerance, 1e-8);
}

void FormsTest::theWheelPassesOverValuesWithoutChangingThem() {
  ui::SceneEditor editor(threeWeights());
  ui::RunsForm runs(&editor);
  ui::WeightsForm weights(&editor);
  QSignalSpy changed(&editor, &ui::SceneEditor::draftChanged);
  QWidget* const passed[] = {runs.findChild<QComboBox*>(),
                             fieldNamed(runs, "Step of run 1")->spinBox(),
                             weights.findChild<QSpinBox*>()};
  for (QWidget* widget : passed) {
    QWheelEvent wheel({5, 5}, widget->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
    QVERIFY(!wheel.isAccepted());
  }
  QCOMPARE(changed.count(), 0);
  QCOMPARE(weights.findChild<QSpinBox*>()->value(), 0);
}

QTEST_MAIN(FormsTest)
#include "forms_test.moc"
