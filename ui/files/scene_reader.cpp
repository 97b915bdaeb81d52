#include "ui/files/scene_reader.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <QRegularExpression>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "ui/files/degree_text.h"
#include "ui/files/problem_line.h"

namespace ui {

namespace {

// Of the whole work, up to the search for overlaps, as measured on 100,000 weights.
constexpr double kShareOfReading = 0.8;

}  // namespace

core::Scene SceneReader::read() {
  checkHeader();
  core::Scene scene = readScene();
  if (m_demand == SceneDemand::kDraft) return scene;
  const std::vector<core::Problem> problems = core::problemsIn(scene);
  if (!problems.empty()) refuse(problems.front());
  return scene;
}

void SceneReader::refuse(const core::Problem& problem) {
  throw ValueRefused{problemLine(problem)};
}

// Goes through the whole text first: a newer file may hold anything, so its version is
// named before any key is called unknown.
void SceneReader::checkHeader() {
  std::optional<std::string> format;
  std::optional<double> version;
  expect(JsonKind::kObject);
  m_json.enter();
  while (const std::optional<std::string> key = m_json.nextKey()) {
    const PlaceScope place(m_place, *key);
    if (key == "format") {
      format = readString();
    } else if (key == "version") {
      version = readNumber();
    } else {
      m_json.skipValue();
    }
  }
  m_json.expectEnd();
  checkFormat(format);
  checkVersion(version);
  m_json = JsonCursor(m_text);
}

void SceneReader::checkFormat(const std::optional<std::string>& format) {
  const PlaceScope place(m_place, "format");
  if (!format) refuse(tr("is missing"));
  if (format != kSceneFormat) {
    refuse(tr("must be %1, got %2").arg(ui::quoted(kSceneFormat), ui::quoted(*format)));
  }
}

void SceneReader::checkVersion(std::optional<double> version) {
  const PlaceScope place(m_place, "version");
  if (!version) refuse(tr("is missing"));
  const QString written = QString::fromStdString(core::numberText(*version));
  if (*version > kSceneVersion) {
    refuse(tr("%1 is newer than this program, which reads version %2")
               .arg(written)
               .arg(kSceneVersion));
  }
  if (*version != kSceneVersion) refuse(tr("must be %1, got %2").arg(kSceneVersion).arg(written));
}

core::Scene SceneReader::readScene() {
  core::Scene scene;
  const auto checked = [&] { m_json.skipValue(); };
  const int mostWeights =
      m_demand == SceneDemand::kDraft ? std::numeric_limits<int>::max() : core::kMostWeights;
  readObject({
      {"format", checked},
      {"version", checked},
      {"name", [&] { scene.name = readString(); }},
      {"description", [&] { scene.description = readString(); }},
      {"gravity", [&] { scene.gravity = readNumber(); }},
      {"airDensity", [&] { scene.airDensity = readNumber(); }},
      {"room", [&] { readRoom(scene.room); }},
      {"restitution", [&] { scene.restitution = readNumber(); }},
      {"cutTime", [&] { scene.cutTime = readNumberOrNull(); }},
      {"weights",
       [&] {
         readList(0, mostWeights, [&] {
           scene.weights.push_back(readWeight());
           showProgress();
         });
       }},
      {"solvers",
       [&] { readList(1, core::kMostSolvers, [&] { scene.solvers.push_back(readSolver()); }); }},
  });
  return scene;
}

void SceneReader::showProgress() {
  const double read = static_cast<double>(m_json.position()) / static_cast<double>(m_text.size());
  if (m_progress && !m_progress(kShareOfReading * read)) throw ReadingStopped{};
}

void SceneReader::readRoom(core::Room& room) {
  readObject({
      {"width", [&] { room.width = readNumber(); }},
      {"height", [&] { room.height = readNumber(); }},
      {"restitution", [&] { room.restitution = readNumber(); }},
      {"friction", [&] { room.friction = readNumber(); }},
  });
}

core::Weight SceneReader::readWeight() {
  core::Weight weight;
  std::optional<Eigen::Vector2d> position;
  std::optional<Eigen::Vector2d> velocity;
  readObject({
      {"mass", [&] { weight.mass = readNumber(); }},
      {"radius", [&] { weight.radius = readNumber(); }},
      {"dragCoefficient", [&] { weight.dragCoefficient = readNumber(); }},
      {"color", [&] { weight.color = readColor(); }},
      {"rope", [&] { weight.rope = readRope(); }},
      {"position", [&] { position = readVector(); }},
      {"velocity", [&] { velocity = readVector(); }},
  });
  if (weight.rope && position) refuse(tr("must have either rope or position, got both"));
  if (!weight.rope && !position) refuse(tr("must have either rope or position, got neither"));
  if (weight.rope && velocity) refuse(tr("velocity goes with position, got it with rope"));
  weight.position = position.value_or(weight.position);
  weight.velocity = velocity.value_or(weight.velocity);
  return weight;
}

core::Rope SceneReader::readRope() {
  core::Rope rope;
  std::optional<Eigen::Vector2d> pivot;
  readObject({
      {"pivot", [&] { pivot = readVector(); }},
      {"length", [&] { rope.length = readNumber(); }},
      {"angle", [&] { rope.angle = readAngle(core::kRopeAngleRange); }},
      {"angularVelocity", [&] { rope.angularVelocity = readAngle(core::kAngularVelocityRange); }},
      {"rigid", [&] { rope.rigid = readBoolean(); }},
  });
  const PlaceScope place(m_place, "pivot");
  if (!pivot) refuse(tr("is missing"));
  rope.pivot = *pivot;
  return rope;
}

core::Solver SceneReader::readSolver() {
  core::Solver solver;
  std::optional<std::string> method;
  std::optional<double> step;
  std::optional<double> tolerance;
  readObject({
      {"method", [&] { method = readMethod(); }},
      {"step", [&] { step = readNumber(); }},
      {"tolerance", [&] { tolerance = readNumber(); }},
  });
  if (!method) {
    const PlaceScope place(m_place, "method");
    refuse(tr("is missing"));
  }
  const QString name = QString::fromStdString(*method);
  const bool isAdaptive = core::findMethod(*method)->isAdaptive;
  if (step && isAdaptive) {
    const PlaceScope place(m_place, "step");
    refuse(tr("%1 takes a tolerance, not a step").arg(name));
  }
  if (tolerance && !isAdaptive) {
    const PlaceScope place(m_place, "tolerance");
    refuse(tr("%1 takes a step, not a tolerance").arg(name));
  }
  solver = {*method, step.value_or(solver.step), tolerance.value_or(solver.tolerance)};
  return solver;
}

std::string SceneReader::readMethod() {
  std::string method = readString();
  if (!core::findOfferedMethod(method)) {
    refuse(tr("there is no method named %1").arg(ui::quoted(method)));
  }
  return method;
}

core::Color SceneReader::readColor() {
  const std::string text = readString();
  static const QRegularExpression kPattern(QStringLiteral("\\A#[0-9A-Fa-f]{6}\\z"));
  if (!kPattern.match(QString::fromStdString(text)).hasMatch()) {
    refuse(tr("must be like \"#e69f00\", got %1").arg(ui::quoted(text)));
  }
  const int rgb = std::stoi(text.substr(1), nullptr, 16);
  const auto part = [rgb](int shift) { return static_cast<std::uint8_t>(rgb >> shift); };
  return {part(16), part(8), part(0)};
}

Eigen::Vector2d SceneReader::readVector() {
  std::vector<double> entries;
  readList(2, 2, [&] { entries.push_back(readNumber()); });
  return {entries[0], entries[1]};
}

double SceneReader::readAngle(const core::Range& allowed) {
  const std::string_view digits = readDigits();
  const double degrees = *numberFromText(digits);
  if (m_demand == SceneDemand::kCanRun && !allowed.contains(degrees)) {
    refuse(core::Problem{.place = m_place,
                         .kind = core::Problem::Kind::kOutOfRange,
                         .value = degrees,
                         .allowed = allowed});
  }
  return radiansFromDegreeText(digits);
}

}  // namespace ui
