#include "ui/files/lessons.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <QCoreApplication>

#include "core/scene/scene.h"

namespace ui {
namespace {

/// A lesson as it is written down: title and sentence are the scene's name and description.
struct Text {
  const char* name;
  double pictureTime;
  const char* title;
  const char* look;
  std::array<const char*, 3> tries;
};

constexpr Text kTexts[] = {
    {"one-pendulum",
     2.3,
     QT_TRANSLATE_NOOP("ui::Lessons", "One pendulum"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch one weight swing, lose its rope on the way up, fly and bounce: Euler swings "
         "higher than it started, RK4 does not."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Press R, then cut the rope yourself with C: when must you cut for the longest throw?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Give Euler a step ten times smaller under Runs: about a tenth of its error is left."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set the air density to 0: does the total still stay flat with both methods?")}},
    {"two-weights",
     1.0,
     QT_TRANSLATE_NOOP("ui::Lessons", "Two weights"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch a small and a large weight of the same lead swing towards each other: when they "
         "meet in the air, the light one is thrown back."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Press I to go to the impact and read the speeds before and after under Events."),
      QT_TRANSLATE_NOOP("ui::Lessons", "Give both weights the same mass: who is thrown back now?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set the restitution of weights to 0: how much energy is lost to the impact?")}},
    {"three-pendulums",
     1.5,
     QT_TRANSLATE_NOOP("ui::Lessons", "Three pendulums"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch three ropes of different length start together and fall out of step: the longer "
         "the rope, the slower the swing."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Make the first rope 0.3 m long: the third, four times as long, swings half as fast."),
      QT_TRANSLATE_NOOP("ui::Lessons", "Change the mass of one weight: is its swing slower now?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Press U to go from one turning point to the next and read the times under Events.")}},
    {"seven-weights",
     2.3,
     QT_TRANSLATE_NOOP("ui::Lessons", "Seven weights in a room"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch seven weights swing, all ropes cut at once: they fly, bounce off each other, the "
         "walls and the floor, and two methods soon disagree about where."),
     {QT_TRANSLATE_NOOP("ui::Lessons", "Press V to give each method a view of its own."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Guess which weight comes to rest first, and look it up under Events."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Halve the step of one method: how much later do the two part?")}},
    {"euler-gains-energy",
     5.0,
     QT_TRANSLATE_NOOP("ui::Lessons", "Euler gains energy"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch Euler swing a pendulum higher and higher without a push, until it goes over the "
         "top: its energy comes from the method, not from physics."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Give Euler a step ten times smaller: it still gains energy, only more slowly."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open the Ledger chart: all that is hatched was made by the method."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Choose Euler (semi-implicit) for the second run and compare.")}},
    {"two-kinds-of-euler",
     5.0,
     QT_TRANSLATE_NOOP("ui::Lessons", "Two kinds of Euler"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch two methods that differ in a single line, whether the new or the old speed moves "
         "the weight: one gains energy for ever, the other never strays far."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open the Phase chart: one draws a closed loop, the other a spiral."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Switch on Runge–Kutta 4 as a third run with the same step: what does its energy do?"),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Let it play for a minute at speed 8×: is the first run still the same?")}},
    {"half-the-step",
     2.6,
     QT_TRANSLATE_NOOP("ui::Lessons", "Half the step"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch the distance from the first run, which is exact: with half the step Euler errs "
         "half as much, and RK4 hardly at all."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open Comparison and read the distances after one second and after four."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Halve the step of Runge–Kutta 4: its error shrinks to about a sixteenth."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open Run ▸ Speed and accuracy to see the same for many steps at once.")}},
    {"step-too-large",
     0.2,
     QT_TRANSLATE_NOOP("ui::Lessons", "Step too large"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch the air stop a balloon in three ways: slowly with a small step, dead with a "
         "larger one, and never with one that throws it back faster each time."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Press R and then → again and again: see how each large step overshoots."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Open Inside a step for the third run: its one slope points far beyond the other side."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Look for the largest step of the third run that does not blow up.")}},
    {"small-and-large-swings",
     2.0,
     QT_TRANSLATE_NOOP("ui::Lessons", "Small and large swings"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch four pendulums of the same length start together: only small swings keep the "
         "same time, and the wider one swings, the longer it takes."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Press U to find the first turning points and compare the times."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set the start angles to 5°, 10°, 15° and 20°: now they keep step for a long time."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Set one start angle to 179.9°: how long does it stay near the top?")}},
    {"slack-rope",
     1.15,
     QT_TRANSLATE_NOOP("ui::Lessons", "Slack rope"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch a rod and a rope with the same push: the rod carries its weight over the top, "
         "the rope goes slack on the way up and jerks tight on the way down."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Switch to speed 1/8× at the moment the rope goes slack: the weight flies as if thrown."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open the Ledger chart: how much energy does the jerk cost?"),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Change gravity until the rope stays taut all the way round.")}},
    {"throw-in-air",
     1.0,
     QT_TRANSLATE_NOOP("ui::Lessons", "A throw with and without air"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch two equal throws, one through air and one that the air does not touch: with air "
         "the path is shorter, lower and steeper at its end."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open the Paths chart: which of the two paths is a parabola?"),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Make the first ball ten times as heavy: how much further does it get?"),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Set the air density to 0: now both paths have the same shape.")}},
    {"terminal-velocity",
     1.3,
     QT_TRANSLATE_NOOP("ui::Lessons", "Terminal velocity"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch three balls of one size fall: the light ones soon fall at a constant speed, "
         "where the drag of the air is as large as their weight."),
     {QT_TRANSLATE_NOOP("ui::Lessons",
                        "Open the Speed chart: whose curve becomes level, and how soon?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Read off both level speeds: the second ball is four times as heavy as the first."),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Set the air density to 0: all three hit the floor together.")}},
    {"bouncing-ball",
     2.2,
     QT_TRANSLATE_NOOP("ui::Lessons", "Infinitely many bounces"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch a ball that loses a fifth of its speed at every bounce: it bounces infinitely "
         "often, and yet all bounces are over within six seconds."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Open the Height chart and zoom in on the end: it looks the same again and again."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Go to the last impacts with I: the times between them form a geometric series."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set the restitution of walls to 0.9: the bounces now last about twice as long.")}},
    {"newtons-cradle",
     1.1,
     QT_TRANSLATE_NOOP("ui::Lessons", "Newton's cradle"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch one weight knock against four that hang at rest: only the last one flies off, "
         "because energy and momentum must both be kept."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Pull two weights aside: give weight 2 the start angle −40°, too. How many fly off?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Play the impacts at speed 1/64×: the push passes through four weights in no time."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set the restitution of weights to 0.5: after a while all swing together.")}},
    {"counting-pi",
     3.4,
     QT_TRANSLATE_NOOP("ui::Lessons", "Counting π by impacts"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch a disc a hundred times as heavy drive a light one against the wall: there are 31 "
         "impacts before they part, the first digits of π."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Open Events and choose Impacts: count them until the heavy disc hits the right wall."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Make the heavy disc 1000 kg, 10⁴ times the light one: there are 314 impacts."),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Give the run a step ten times as large: the number stays the same. Why?")}},
    {"thousand-pendulums",
     2.3,
     QT_TRANSLATE_NOOP("ui::Lessons", "A thousand pendulums"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch a thousand pendulums start as one straight line, each a hair longer than the "
         "next: the line bends, winds up and falls apart into dust."),
     {QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Stop after 5 s and after 20 s: are weights that started side by side still neighbours?"),
      QT_TRANSLATE_NOOP("ui::Lessons",
                        "Set all start angles to 170°: does the line fall apart sooner?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Press C while they swing: a thousand weights fly off along a thousand paths.")}},
    {"pile",
     0.8,
     QT_TRANSLATE_NOOP("ui::Lessons", "A pile comes to rest"),
     QT_TRANSLATE_NOOP(
         "ui::Lessons",
         "Watch balls rain into a box and settle: every impact takes some energy, until all lie "
         "still and no ball overlaps another."),
     {QT_TRANSLATE_NOOP("ui::Lessons", "Open the Ledger chart: where has all the energy gone?"),
      QT_TRANSLATE_NOOP(
          "ui::Lessons",
          "Set both restitutions to 0.8: how much longer does it take until all lie still?"),
      QT_TRANSLATE_NOOP("ui::Lessons", "Make the room twice as wide: how high is the pile now?")}},
};

QString translated(const char* words) {
  return QCoreApplication::translate("ui::Lessons", words);
}

Lesson lessonOf(const Text& text) {
  Lesson lesson{QString::fromLatin1(text.name),
                translated(text.title),
                translated(text.look),
                {},
                text.pictureTime};
  for (const char* words : text.tries) lesson.tries.append(translated(words));
  return lesson;
}

}  // namespace

std::vector<Lesson> lessons() {
  std::vector<Lesson> all;
  std::ranges::transform(kTexts, std::back_inserter(all), lessonOf);
  return all;
}

QString lessonNameOf(const core::Scene& scene) {
  const auto found = std::ranges::find_if(kTexts, [&](const Text& text) {
    return scene.name == text.title && scene.description == text.look;
  });
  return found == std::end(kTexts) ? QString() : QString::fromLatin1(found->name);
}

QString titleOf(const core::Scene& scene) {
  const QString lesson = lessonNameOf(scene);
  return lesson.isEmpty() ? QString::fromStdString(scene.name) : lessonNamed(lesson).title;
}

Lesson lessonNamed(const QString& name) {
  const auto found = std::ranges::find_if(
      kTexts, [&](const Text& text) { return name == QLatin1String(text.name); });
  Q_ASSERT(found != std::end(kTexts));
  return lessonOf(*found);
}

}  // namespace ui
