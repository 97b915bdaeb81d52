#include "ui/panels/quantity_field.h"

#include <cmath>
#include <numbers>

#include <QLocale>
#include <QPushButton>
#include <QShortcut>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

using ui::QuantityField;

namespace {

constexpr core::Range kLength{0.001, 10000, "m"};

/// Types over what the field shows, as a person does who tabbed into it.
void type(QuantityField& field, const QString& text) {
  field.spinBox()->setFocus();
  field.spinBox()->selectAll();
  QTest::keyClicks(field.spinBox(), text);
}

void enter(QuantityField& field, const QString& text) {
  type(field, text);
  QTest::keyClick(field.spinBox(), Qt::Key_Return);
}

}  // namespace

class QuantityFieldTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }
  void appliesWhatIsTypedOnReturn();
  void appliesWhatIsTypedWhenLeft();
  void appliesNothingWhenNothingChanged();
  void marksABadValueInPlaceAndDoesNotApplyIt_data();
  void marksABadValueInPlaceAndDoesNotApplyIt();
  void keepsABadTextWhileItsValueIsShownAgain();
  void escapeBringsBackTheLastValue();
  void showsDegreesAndGivesRadians();
  void arrowsGoToWholeMultiples();
  void arrowsDoubleAndHalveSteps();
  void arrowsMakeTolerancesTenTimesLarger();
  void arrowsStopAtTheRangesEnds();
  void refusesPartsWhereOnlyWholeNumbersCount();
  void returnHandsTheKeyboardBackToTheWindow();
  void spaceAppliesTheValueAndStaysTheWindowsKey();
};

void QuantityFieldTest::appliesWhatIsTypedOnReturn() {
  QuantityField field({kLength});
  field.setValue(1);
  QSignalSpy edited(&field, &QuantityField::edited);
  enter(field, "2,5");
  QCOMPARE(edited.count(), 1);
  QCOMPARE(edited.first().first().toDouble(), 2.5);
  QCOMPARE(field.spinBox()->text(), QString("2.5 m"));
}

void QuantityFieldTest::appliesWhatIsTypedWhenLeft() {
  QWidget window;
  auto* layout = new QVBoxLayout(&window);
  auto* field = new QuantityField({kLength});
  auto* other = new QuantityField({kLength});
  layout->addWidget(field);
  layout->addWidget(other);
  window.show();
  QVERIFY(QTest::qWaitForWindowActive(&window));
  field->setValue(1);
  QSignalSpy edited(field, &QuantityField::edited);
  type(*field, "3");
  QCOMPARE(edited.count(), 0);
  other->spinBox()->setFocus();
  QCOMPARE(edited.count(), 1);
}

void QuantityFieldTest::appliesNothingWhenNothingChanged() {
  QuantityField field({kLength});
  field.setValue(1.0 / 3);  // shown in fewer digits than it has
  QSignalSpy edited(&field, &QuantityField::edited);
  QTest::keyClick(field.spinBox(), Qt::Key_Return);
  QCOMPARE(edited.count(), 0);
}

void QuantityFieldTest::marksABadValueInPlaceAndDoesNotApplyIt_data() {
  QTest::addColumn<QString>("text");
  for (const char* text : {"-1", "0", "10001", "abc", "1/0"}) QTest::newRow(text) << text;
}

void QuantityFieldTest::marksABadValueInPlaceAndDoesNotApplyIt() {
  QFETCH(QString, text);
  QuantityField field({kLength});
  field.setValue(1);
  QSignalSpy edited(&field, &QuantityField::edited);
  enter(field, text);
  QCOMPARE(edited.count(), 0);
  QCOMPARE(field.reason(), QString("Must be from 0.001 to 10000\u00a0m"));
  QCOMPARE(field.spinBox()->text(), text);

  enter(field, "2");
  QVERIFY(!field.isMarked());
  QCOMPARE(edited.count(), 1);
}

void QuantityFieldTest::keepsABadTextWhileItsValueIsShownAgain() {
  QuantityField field({kLength});
  field.setValue(1);
  enter(field, "-1");
  field.setValue(1);
  QCOMPARE(field.spinBox()->text(), QString("-1"));
  QVERIFY(field.isMarked());
  field.setValue(2);
  QCOMPARE(field.spinBox()->text(), QString("2 m"));
  QVERIFY(!field.isMarked());
}

void QuantityFieldTest::escapeBringsBackTheLastValue() {
  QuantityField field({kLength});
  field.setValue(1);
  enter(field, "-1");
  QTest::keyClick(field.spinBox(), Qt::Key_Escape);
  QCOMPARE(field.spinBox()->text(), QString("1 m"));
  QVERIFY(!field.isMarked());
}

void QuantityFieldTest::showsDegreesAndGivesRadians() {
  QuantityField field({core::kRopeAngleRange, 5});
  field.setValue(std::numbers::pi / 3);
  QCOMPARE(field.spinBox()->text(), QString("60°"));
  QSignalSpy edited(&field, &QuantityField::edited);
  enter(field, "-90");
  QCOMPARE(edited.first().first().toDouble(), -std::numbers::pi / 2);
}

void QuantityFieldTest::arrowsGoToWholeMultiples() {
  QuantityField field({core::kGravityRange, 0.1});
  field.setValue(9.81);
  QSignalSpy edited(&field, &QuantityField::edited);
  QTest::keyClick(field.spinBox(), Qt::Key_Up);
  QCOMPARE(field.spinBox()->text(), QString("9.9 m/s²"));
  QTest::keyClick(field.spinBox(), Qt::Key_Down);
  QTest::keyClick(field.spinBox(), Qt::Key_Down);
  QCOMPARE(field.spinBox()->text(), QString("9.7 m/s²"));
  QCOMPARE(edited.count(), 3);
}

void QuantityFieldTest::arrowsDoubleAndHalveSteps() {
  QuantityField field({.range = core::kStepRange, .arrowsDouble = true});
  field.setValue(1.0 / 60);
  QTest::keyClick(field.spinBox(), Qt::Key_Down);
  QCOMPARE(field.spinBox()->text(), QString("1/120 s"));
}

void QuantityFieldTest::arrowsMakeTolerancesTenTimesLarger() {
  QuantityField field({.range = core::kToleranceRange, .arrowsTenfold = true});
  field.setValue(1e-9);
  QTest::keyClick(field.spinBox(), Qt::Key_Up);
  QCOMPARE(field.spinBox()->text(), QString("1e-8"));
  field.setValue(1e-14);
  QTest::keyClick(field.spinBox(), Qt::Key_Down);
  QCOMPARE(field.spinBox()->text(), QString("1e-14"));
}

void QuantityFieldTest::arrowsStopAtTheRangesEnds() {
  QuantityField field({core::kRestitutionRange, 0.3});
  field.setValue(0.9);
  QSignalSpy edited(&field, &QuantityField::edited);
  QTest::keyClick(field.spinBox(), Qt::Key_Up);
  QCOMPARE(edited.count(), 0);
  QCOMPARE(field.spinBox()->text(), QString("0.9"));
}

void QuantityFieldTest::refusesPartsWhereOnlyWholeNumbersCount() {
  QuantityField field({.range = {0, 100, ""}, .arrowStep = 1, .wholeNumbers = true});
  field.setValue(3);
  QSignalSpy edited(&field, &QuantityField::edited);
  enter(field, "3.5");
  QCOMPARE(edited.count(), 0);
  QVERIFY(field.isMarked());
}

void QuantityFieldTest::returnHandsTheKeyboardBackToTheWindow() {
  QuantityField field({kLength});
  field.show();
  QVERIFY(QTest::qWaitForWindowActive(&field));
  field.spinBox()->setFocus();
  QVERIFY(field.spinBox()->hasFocus());
  QTest::keyClick(field.spinBox(), Qt::Key_Return);
  QVERIFY(!field.spinBox()->hasFocus());
}

void QuantityFieldTest::spaceAppliesTheValueAndStaysTheWindowsKey() {
  QuantityField field({kLength});
  QShortcut shortcut(QKeySequence(Qt::Key_Space), &field);
  QSignalSpy pressed(&shortcut, &QShortcut::activated);
  QSignalSpy edited(&field, &QuantityField::edited);
  field.show();
  QVERIFY(QTest::qWaitForWindowActive(&field));
  field.setValue(1);
  type(field, "2");
  QTest::keyClick(field.spinBox(), Qt::Key_Space);
  QCOMPARE(edited.count(), 1);
  QCOMPARE(pressed.count(), 1);
}

QTEST_MAIN(QuantityFieldTest)
#include "quantity_field_test.moc"
