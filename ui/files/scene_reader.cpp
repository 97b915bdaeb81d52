#include "ui/files/scene_reader.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <QRegularExpression>

#include "core/methods/method.h"
#include "core/scene/scene_limits.h"
#include "ui/files/degree_text.h"

namespace ui {

namespace {

/// Names a value's place while it is read: "weights", then "weights[3]" inside.
class PlaceScope {
 public:
  PlaceScope(std::string& place, std::string_view key) : PlaceScope(place) {
    if (!m_place.empty()) m_place += '.';
    m_place += key;
  }
  PlaceScope(std::string& place, int index) : PlaceScope(place) {
    m_place += '[' + std::to_string(index) + ']';
  }
  ~PlaceScope() { m_place.resize(m_outerLength); }
  Q_DISABLE_COPY_MOVE(PlaceScope)

 private:
  explicit PlaceScope(std::string& place) : m_place(place), m_outerLength(place.size()) {}

  std::string& m_place;
  std::size_t m_outerLength;
};

/// Text from a file, fit to stand in a message of one line.
QString quoted(std::string_view text) {
  constexpr qsizetype kLongest = 40;
  QString shown = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  for (QChar& character : shown) {
    if (!character.isPrint() && !character.isSurrogate()) character = QChar::ReplacementCharacter;
  }
  if (shown.size() > kLongest) shown = shown.left(kLongest) + QChar(0x2026);
  return '"' + shown + '"';
}

QString describe(JsonKind kind) {
  switch (kind) {
    case JsonKind::kNull:
      return SceneReader::tr("null");
    case JsonKind::kBoolean:
      return SceneReader::tr("true or false");
    case JsonKind::kNumber:
      return SceneReader::tr("a number");
    case JsonKind::kString:
      return SceneReader::tr("a text");
    case JsonKind::kArray:
      return SceneReader::tr("a list");
    case JsonKind::kObject:
      return SceneReader::tr("an object");
  }
  return {};
}

}  // namespace

core::Scene SceneReader::read() {
  checkHeader();
  core::Scene scene = readScene();
  const std::vector<core::Problem> problems = core::problemsIn(scene);
  if (!problems.empty()) refuse(problems.front());
  return scene;
}

void SceneReader::refuse(const QString& reason) const {
  const QString place = m_place.empty() ? tr("scene") : QString::fromStdString(m_place);
  throw SceneRefused{place + QStringLiteral(": ") + reason};
}

void SceneReader::refuse(const core::Problem& problem) {
  throw SceneRefused{QString::fromStdString(core::messageFor(problem))};
}

void SceneReader::expect(JsonKind kind) {
  const JsonKind found = m_json.kind();
  if (found != kind) refuse(tr("must be %1, got %2").arg(describe(kind), describe(found)));
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
    refuse(tr("must be %1, got %2").arg(quoted(kSceneFormat), quoted(*format)));
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
       [&] { readList(0, core::kMostWeights, [&] { scene.weights.push_back(readWeight()); }); }},
      {"solvers",
       [&] { readList(1, core::kMostSolvers, [&] { scene.solvers.push_back(readSolver()); }); }},
  });
  return scene;
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
  std::optional<double> tolerance;
  readObject({
      {"method", [&] { method = readMethod(); }},
      {"step", [&] { solver.step = readNumber(); }},
      {"tolerance", [&] { tolerance = readNumber(); }},
  });
  if (!method) {
    const PlaceScope place(m_place, "method");
    refuse(tr("is missing"));
  }
  if (tolerance) {
    const PlaceScope place(m_place, "tolerance");
    refuse(tr("%1 takes a step, not a tolerance").arg(QString::fromStdString(*method)));
  }
  solver.method = *method;
  return solver;
}

std::string SceneReader::readMethod() {
  std::string method = readString();
  if (!core::findMethod(method)) {
    refuse({m_place,
            core::Problem::Kind::kUnknownMethod,
            0,
            {0, 0, ""},
            -1,
            quoted(method).toStdString()});
  }
  return method;
}

core::Color SceneReader::readColor() {
  const std::string text = readString();
  static const QRegularExpression kPattern(QStringLiteral("\\A#[0-9A-Fa-f]{6}\\z"));
  if (!kPattern.match(QString::fromStdString(text)).hasMatch()) {
    refuse(tr("must be like \"#e69f00\", got %1").arg(quoted(text)));
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

std::string_view SceneReader::readDigits() {
  expect(JsonKind::kNumber);
  const std::string_view digits = m_json.readNumber();
  if (!numberFromText(digits)) {
    refuse(tr("%1 is too large or too small to reckon with").arg(quoted(digits)));
  }
  return digits;
}

double SceneReader::readNumber() {
  return *numberFromText(readDigits());
}

std::optional<double> SceneReader::readNumberOrNull() {
  if (m_json.kind() != JsonKind::kNull) return readNumber();
  m_json.readNull();
  return std::nullopt;
}

double SceneReader::readAngle(const core::Range& allowed) {
  const std::string_view digits = readDigits();
  const double degrees = *numberFromText(digits);
  if (!allowed.contains(degrees)) {
    refuse({m_place, core::Problem::Kind::kOutOfRange, degrees, allowed, -1, {}});
  }
  return radiansFromDegreeText(digits);
}

bool SceneReader::readBoolean() {
  expect(JsonKind::kBoolean);
  return m_json.readBoolean();
}

std::string SceneReader::readString() {
  expect(JsonKind::kString);
  return m_json.readString();
}

void SceneReader::readObject(std::initializer_list<Member> members) {
  expect(JsonKind::kObject);
  std::uint32_t seen = 0;
  m_json.enter();
  while (const std::optional<std::string> key = m_json.nextKey()) {
    const auto member = std::ranges::find(members, *key, &Member::key);
    if (member == members.end()) refuse(tr("unknown key %1").arg(quoted(*key)));
    const PlaceScope place(m_place, *key);
    const std::uint32_t bit = 1U << (member - members.begin());
    if (seen & bit) refuse(tr("stands twice"));
    seen |= bit;
    member->read();
  }
}

void SceneReader::readList(int fewest, int most, const std::function<void()>& readEntry) {
  expect(JsonKind::kArray);
  int count = 0;
  m_json.enter();
  for (; m_json.nextElement(); ++count) {
    if (count < most) {
      const PlaceScope place(m_place, count);
      readEntry();
    } else {
      m_json.skipValue();  // to say how many there are
    }
  }
  if (count >= fewest && count <= most) return;
  refuse(fewest == most
             ? tr("must have %1 entries, got %2").arg(most).arg(count)
             : tr("must have %1 to %2 entries, got %3").arg(fewest).arg(most).arg(count));
}

}  // namespace ui
