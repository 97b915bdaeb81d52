#include "ui/files/problem_line.h"

#include <limits>

#include <QTest>

#include "core/scene/scene_limits.h"
#include "ui/control/translations.h"

using core::Problem;
using ui::Language;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Problem outOfRange(const char* place, double value, const core::Range& allowed) {
  return {.place = place, .kind = Problem::Kind::kOutOfRange, .value = value, .allowed = allowed};
}

Problem outside(const char* place, double radius, const Eigen::Vector2d& at) {
  return {.place = place, .kind = Problem::Kind::kOutsideRoom, .value = radius, .at = at};
}

Problem overlap() {
  return {.place = "weights[1]", .kind = Problem::Kind::kOverlap, .other = 0};
}

Problem tooMany() {
  return {.place = "solvers", .kind = Problem::Kind::kTooMany, .value = 5, .allowed = {0, 4, ""}};
}

}  // namespace

class ProblemLineTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { ui::speak(Language::kEnglish); }
  void saysWhereAndWhatIsWrong_data();
  void saysWhereAndWhatIsWrong();
  void saysItInTheReadersLanguage_data();
  void saysItInTheReadersLanguage();
};

void ProblemLineTest::saysWhereAndWhatIsWrong_data() {
  QTest::addColumn<Problem>("problem");
  QTest::addColumn<QString>("line");
  const auto add = [](const Problem& problem, const char* line) {
    QTest::newRow(line) << problem << line;
  };
  add(outOfRange("weights[1].rope.length", -1, core::kRopeLengthRange),
      "weights[1].rope.length: must be from 0.001 to 10000 m, got -1");
  add(outOfRange("cutTime", -1, core::kCutTimeRange), "cutTime: must be at least 0 s, got -1");
  add(outOfRange("room.restitution", 1.5, core::kRestitutionRange),
      "room.restitution: must be from 0 to 1, got 1.5");
  add(outOfRange("weights[0].mass", 0, core::kMassRange),
      "weights[0].mass: must be from 1e-6 to 1e9 kg, got 0");
  add(outOfRange("weights[1].rope.angle", 200, core::kRopeAngleRange),
      "weights[1].rope.angle: must be from -180 to 180 °, got 200");
  add(outOfRange("gravity", kInfinity, core::kGravityRange),
      "gravity: must be from 0 to 1000 m/s², got inf");
  add(outOfRange("room.height", kNaN, core::kRoomSizeRange),
      "room.height: must be from 0.01 to 100000 m, got nan");
  add(outside("weights[1].rope.pivot", 0, {2, 3.5}),
      "weights[1].rope.pivot: must be inside the room, got [2, 3.5]");
  add(outside("weights[0].position", 0.02, {0.01, 1}),
      "weights[0].position: must put the whole weight, of radius 0.02 m, inside the room, got "
      "[0.01, 1]");
  add(overlap(), "weights[1]: must not overlap weights[0] at the start");
  add(tooMany(), "solvers: must be at most 4, got 5");
}

void ProblemLineTest::saysWhereAndWhatIsWrong() {
  QFETCH(Problem, problem);
  QFETCH(QString, line);
  QCOMPARE(ui::problemLine(problem), line);
}

void ProblemLineTest::saysItInTheReadersLanguage_data() {
  QTest::addColumn<Language>("language");
  QTest::addColumn<Problem>("problem");
  QTest::addColumn<QString>("line");
  const auto add = [](Language language, const Problem& problem, const char* line) {
    QTest::addRow("%s, %s", qPrintable(ui::nameOf(language)), problem.place.c_str())
        << language << problem << line;
  };
  // Keys and numbers are those of the file.
  const Problem mass = outOfRange("weights[1].mass", -0.5, core::kMassRange);
  const Problem cut = outOfRange("cutTime", -1, core::kCutTimeRange);
  const Problem pivot = outside("weights[1].rope.pivot", 0, {2, 3.5});
  const Problem disc = outside("weights[0].position", 0.02, {0.01, 1});
  add(Language::kSwedish, mass, "weights[1].mass: måste vara från 1e-6 till 1e9 kg, är -0.5");
  add(Language::kSwedish, cut, "cutTime: måste vara minst 0 s, är -1");
  add(Language::kSwedish, pivot, "weights[1].rope.pivot: måste ligga i rummet, är [2, 3.5]");
  add(Language::kSwedish, disc,
      "weights[0].position: måste hålla hela vikten, med radien 0.02 m, i "
      "rummet, är [0.01, 1]");
  add(Language::kSwedish, overlap(), "weights[1]: får inte överlappa weights[0] vid starten");
  add(Language::kSwedish, tooMany(), "solvers: får vara högst 4, är 5");
  add(Language::kGerman, mass, "weights[1].mass: muss von 1e-6 bis 1e9 kg sein, ist aber -0.5");
  add(Language::kGerman, cut, "cutTime: muss mindestens 0 s sein, ist aber -1");
  add(Language::kGerman, pivot, "weights[1].rope.pivot: muss im Raum liegen, ist aber [2, 3.5]");
  add(Language::kGerman, disc,
      "weights[0].position: muss das ganze Gewicht, mit Radius 0.02 m, im "
      "Raum halten, ist aber [0.01, 1]");
  add(Language::kGerman, overlap(), "weights[1]: darf weights[0] beim Start nicht überlappen");
  add(Language::kGerman, tooMany(), "solvers: darf höchstens 4 sein, ist aber 5");
  add(Language::kFrench, mass,
      "weights[1].mass: attendu\u00a0: de 1e-6 à 1e9 kg\u00a0; lu\u00a0: -0.5");
  add(Language::kFrench, cut, "cutTime: attendu\u00a0: au moins 0 s\u00a0; lu\u00a0: -1");
  add(Language::kFrench, pivot,
      "weights[1].rope.pivot: attendu\u00a0: un point dans la pièce\u00a0; "
      "lu\u00a0: [2, 3.5]");
  add(Language::kFrench, disc,
      "weights[0].position: attendu\u00a0: la bille entière, de rayon 0.02 "
      "m, dans la pièce\u00a0; lu\u00a0: [0.01, 1]");
  add(Language::kFrench, overlap(), "weights[1]: ne doit pas recouvrir weights[0] au départ");
  add(Language::kFrench, tooMany(), "solvers: attendu\u00a0: au plus 4\u00a0; lu\u00a0: 5");
  add(Language::kSpanish, mass, "weights[1].mass: se esperaba de 1e-6 a 1e9 kg, no -0.5");
  add(Language::kSpanish, cut, "cutTime: se esperaba al menos 0 s, no -1");
  add(Language::kSpanish, pivot,
      "weights[1].rope.pivot: debe estar dentro de la sala, no en [2, 3.5]");
  add(Language::kSpanish, disc,
      "weights[0].position: debe dejar toda la pesa, de radio 0.02 m, dentro "
      "de la sala, no en [0.01, 1]");
  add(Language::kSpanish, overlap(), "weights[1]: no debe solaparse con weights[0] al inicio");
  add(Language::kSpanish, tooMany(), "solvers: se esperaba como máximo 4, no 5");
}

void ProblemLineTest::saysItInTheReadersLanguage() {
  QFETCH(Language, language);
  QFETCH(Problem, problem);
  QFETCH(QString, line);
  ui::speak(language);
  QCOMPARE(ui::problemLine(problem), line);
}

QTEST_GUILESS_MAIN(ProblemLineTest)
#include "problem_line_test.moc"
