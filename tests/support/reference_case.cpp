#include "tests/support/reference_case.h"

#include <algorithm>
#include <initializer_list>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/scene/angle.h"

namespace tests {
namespace {

/// @return  the first of `all` whose name in files is `name`; ends the program without one
template <class Named>
Named named(std::initializer_list<Named> all, const QString& name) {
  for (const Named value : all) {
    const std::string_view word = core::nameOf(value);
    if (name == QLatin1String(word.data(), static_cast<qsizetype>(word.size()))) return value;
  }
  qFatal("unknown name %s", qPrintable(name));
}

core::Phase phaseNamed(const QString& name) {
  using enum core::Phase;
  return named({kTethered, kSlack, kFlying, kResting}, name);
}

core::EventKind eventNamed(const QString& name) {
  using enum core::EventKind;
  return named({kCut, kTurningPoint, kSlack, kTaut, kImpactFloor, kImpactCeiling, kImpactWest,
                kImpactEast, kImpactWeight, kRest},
               name);
}

Eigen::Vector2d pairIn(const QJsonValue& value) {
  return {value[0].toDouble(), value[1].toDouble()};
}

core::Weight weightIn(const QJsonObject& json) {
  core::Weight weight;
  weight.mass = json["mass"].toDouble();
  weight.radius = json["radius"].toDouble();
  weight.dragCoefficient = json["dragCoefficient"].toDouble();
  if (const QJsonValue rope = json["rope"]; rope.isObject()) {
    weight.rope = core::Rope{.pivot = pairIn(rope["pivot"]),
                             .length = rope["length"].toDouble(),
                             .angle = core::radians(rope["angle"].toDouble()),
                             .angularVelocity = core::radians(rope["angularVelocity"].toDouble()),
                             .rigid = rope["rigid"].toBool()};
  } else {
    weight.position = pairIn(json["position"]);
    weight.velocity = pairIn(json["velocity"]);
  }
  return weight;
}

std::shared_ptr<const core::Scene> sceneIn(const QJsonObject& json) {
  auto scene = std::make_shared<core::Scene>();
  scene->gravity = json["gravity"].toDouble();
  scene->airDensity = json["airDensity"].toDouble();
  const QJsonObject room = json["room"].toObject();
  scene->room = {room["width"].toDouble(), room["height"].toDouble(),
                 room["restitution"].toDouble(), room["friction"].toDouble()};
  scene->restitution = json["restitution"].toDouble();
  if (json["cutTime"].isDouble()) scene->cutTime = json["cutTime"].toDouble();
  for (const QJsonValue weight : json["weights"].toArray())
    scene->weights.push_back(weightIn(weight.toObject()));
  return scene;
}

core::WeightState weightStateIn(const QJsonObject& json) {
  core::WeightState state;
  state.phase = phaseNamed(json["phase"].toString());
  state.position = {json["x"].toDouble(), json["y"].toDouble()};
  state.velocity = {json["vx"].toDouble(), json["vy"].toDouble()};
  state.angle = core::radians(json["angle"].toDouble());
  state.angularVelocity = core::radians(json["angular_velocity"].toDouble());
  return state;
}

Moment momentIn(const QJsonObject& json) {
  Moment moment{json["time"].toDouble(), {}, {}};
  moment.energies.kinetic = json["kinetic"].toDouble();
  moment.energies.potential = json["potential"].toDouble();
  moment.energies.lostToAir = json["lost_to_air"].toDouble();
  moment.energies.lostToImpacts = json["lost_to_impacts"].toDouble();
  moment.energies.lostToRopes = json["lost_to_ropes"].toDouble();
  for (const QJsonValue weight : json["weights"].toArray())
    moment.weights.push_back(weightStateIn(weight.toObject()));
  return moment;
}

core::Event eventIn(const QJsonObject& json) {
  core::Event event;
  event.time = json["time"].toDouble();
  event.kind = eventNamed(json["event"].toString());
  event.weight = json["weight"].toInt(-1);
  event.other = json["other"].toInt(-1);
  event.position = {json["x"].toDouble(), json["y"].toDouble()};
  event.energyLost = json["energy_lost"].toDouble();
  return event;
}

Moment momentOf(const core::Run& run, double time) {
  Moment moment{time, run.energiesAt(time), {}};
  for (int i = 0; i < run.weightCount(); ++i) moment.weights.push_back(run.weightAt(i, time));
  return moment;
}

}  // namespace

QStringList referenceNames() {
  QStringList names = QDir(ANGRYCUTS_REFERENCE_DIR).entryList({"*.json"}, QDir::Files, QDir::Name);
  names.replaceInStrings(".json", QString());
  return names;
}

ReferenceCase referenceCase(const QString& name) {
  QFile file(QDir(ANGRYCUTS_REFERENCE_DIR).filePath(name + ".json"));
  if (!file.open(QIODevice::ReadOnly)) qFatal("cannot read %s", qPrintable(file.fileName()));
  const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
  ReferenceCase reference{name, sceneIn(json["scene"].toObject()), {}};
  for (const QJsonValue moment : json["exact"].toArray())
    reference.exact.moments.push_back(momentIn(moment.toObject()));
  for (const QJsonValue event : json["events"].toArray())
    reference.exact.events.push_back(eventIn(event.toObject()));
  if (reference.exact.moments.empty()) qFatal("nothing known in %s", qPrintable(file.fileName()));
  return reference;
}

Course simulated(const ReferenceCase& reference, const core::Solver& solver) {
  core::Run run(reference.scene, solver);
  Course course;
  for (const Moment& exact : reference.exact.moments) {
    while (run.time() < exact.time && run.advance() == core::RunStatus::kRunning)
      course.events.insert(course.events.end(), run.stepEvents().begin(), run.stepEvents().end());
    course.moments.push_back(momentOf(run, exact.time));
  }
  const double last = reference.exact.moments.back().time;
  std::erase_if(course.events, [last](const core::Event& event) { return event.time > last; });
  return course;
}

double positionError(const ReferenceCase& reference, const Course& course) {
  double largest = 0;
  for (std::size_t i = 0; i < course.moments.size(); ++i)
    for (std::size_t w = 0; w < course.moments[i].weights.size(); ++w) {
      const Eigen::Vector2d& exact = reference.exact.moments[i].weights[w].position;
      largest = std::max(largest, (course.moments[i].weights[w].position - exact).norm());
    }
  return largest;
}

}  // namespace tests
