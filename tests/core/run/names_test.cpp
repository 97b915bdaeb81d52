#include <QtTest>

#include "core/run/event.h"
#include "core/run/phase.h"

using core::EventKind;
using core::Phase;

namespace {

QString text(std::string_view word) {
  return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
}

}  // namespace

/// Other programs and lessons rely on these words.
class NamesTest : public QObject {
  Q_OBJECT

 private slots:
  void eventsAreCalledAsInFiles_data();
  void eventsAreCalledAsInFiles();
  void phasesAreCalledAsInFiles_data();
  void phasesAreCalledAsInFiles();
};

void NamesTest::eventsAreCalledAsInFiles_data() {
  QTest::addColumn<EventKind>("kind");
  QTest::newRow("cut") << EventKind::kCut;
  QTest::newRow("turning-point") << EventKind::kTurningPoint;
  QTest::newRow("slack") << EventKind::kSlack;
  QTest::newRow("taut") << EventKind::kTaut;
  QTest::newRow("impact-floor") << EventKind::kImpactFloor;
  QTest::newRow("impact-ceiling") << EventKind::kImpactCeiling;
  QTest::newRow("impact-west") << EventKind::kImpactWest;
  QTest::newRow("impact-east") << EventKind::kImpactEast;
  QTest::newRow("impact-weight") << EventKind::kImpactWeight;
  QTest::newRow("rest") << EventKind::kRest;
}

void NamesTest::eventsAreCalledAsInFiles() {
  QFETCH(EventKind, kind);
  QCOMPARE(text(core::nameOf(kind)), QString(QTest::currentDataTag()));
}

void NamesTest::phasesAreCalledAsInFiles_data() {
  QTest::addColumn<Phase>("phase");
  QTest::newRow("tethered") << Phase::kTethered;
  QTest::newRow("slack") << Phase::kSlack;
  QTest::newRow("flying") << Phase::kFlying;
  QTest::newRow("resting") << Phase::kResting;
}

void NamesTest::phasesAreCalledAsInFiles() {
  QFETCH(Phase, phase);
  QCOMPARE(text(core::nameOf(phase)), QString(QTest::currentDataTag()));
}

QTEST_APPLESS_MAIN(NamesTest)
#include "names_test.moc"
