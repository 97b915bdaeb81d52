#include "core/scene/scene_limits.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/scene/angle.h"
#include "core/scene/overlaps.h"

namespace core {

namespace {

std::string entry(std::string_view list, std::size_t index) {
  return std::string(list) + '[' + std::to_string(index) + ']';
}

/// One pass over a scene that notes what is wrong, in the order of a scene file.
class Inspection {
 public:
  explicit Inspection(const Scene& scene) : m_scene(scene) {}

  std::vector<Problem> problems() && {
    checkSurroundings();
    checkWeights();
    checkSolvers();
    return std::move(m_problems);
  }

 private:
  bool check(std::string place, double value, const Range& allowed) {
    if (allowed.contains(value)) return true;
    m_problems.push_back({.place = std::move(place),
                          .kind = Problem::Kind::kOutOfRange,
                          .value = value,
                          .allowed = allowed});
    return false;
  }

  void checkCount(std::string place, std::size_t count, int most) {
    if (count <= static_cast<std::size_t>(most)) return;
    m_problems.push_back({.place = std::move(place),
                          .kind = Problem::Kind::kTooMany,
                          .value = static_cast<double>(count),
                          .allowed = {0, static_cast<double>(most), ""}});
  }

  /// @param radius  of the disc around `point`; 0 for a bare point
  bool checkInside(std::string place, const Eigen::Vector2d& point, double radius) {
    if (!m_roomIsSound) return false;
    const double margin = radius * (1 - kTouchTolerance);
    const Range across{margin, m_scene.room.width - margin, "m"};
    const Range upwards{margin, m_scene.room.height - margin, "m"};
    if (across.contains(point.x()) && upwards.contains(point.y())) return true;
    m_problems.push_back({.place = std::move(place),
                          .kind = Problem::Kind::kOutsideRoom,
                          .value = radius,
                          .at = point});
    return false;
  }

  void checkSurroundings() {
    check("gravity", m_scene.gravity, kGravityRange);
    check("airDensity", m_scene.airDensity, kAirDensityRange);
    const Room& room = m_scene.room;
    const bool widthIsSound = check("room.width", room.width, kRoomSizeRange);
    const bool heightIsSound = check("room.height", room.height, kRoomSizeRange);
    m_roomIsSound = widthIsSound && heightIsSound;
    check("room.restitution", room.restitution, kRestitutionRange);
    check("room.friction", room.friction, kFrictionRange);
    check("restitution", m_scene.restitution, kRestitutionRange);
    if (m_scene.cutTime) check("cutTime", *m_scene.cutTime, kCutTimeRange);
  }

  void checkWeights() {
    const std::vector<Weight>& weights = m_scene.weights;
    checkCount("weights", weights.size(), kMostWeights);
    const std::vector<Overlap> overlaps = overlapsAmong(startDiscs(m_scene));
    auto overlap = overlaps.begin();
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const std::string place = entry("weights", i);
      checkWeight(place, weights[i]);
      if (overlap != overlaps.end() && static_cast<std::size_t>(overlap->disc) == i) {
        m_problems.push_back(
            {.place = place, .kind = Problem::Kind::kOverlap, .other = overlap->other});
        ++overlap;
      }
    }
  }

  void checkWeight(const std::string& place, const Weight& weight) {
    check(place + ".mass", weight.mass, kMassRange);
    const bool radiusIsSound = check(place + ".radius", weight.radius, kRadiusRange);
    check(place + ".dragCoefficient", weight.dragCoefficient, kDragCoefficientRange);
    if (weight.rope) {
      const bool ropeIsSound = checkRope(place + ".rope", *weight.rope);
      if (ropeIsSound && radiusIsSound) {
        checkInside(place + ".rope", startPosition(weight), weight.radius);
      }
      return;
    }
    if (radiusIsSound) checkInside(place + ".position", weight.position, weight.radius);
    check(place + ".velocity[0]", weight.velocity.x(), kVelocityRange);
    check(place + ".velocity[1]", weight.velocity.y(), kVelocityRange);
  }

  /// @return  whether the weight's start can be told from the rope
  bool checkRope(const std::string& place, const Rope& rope) {
    const bool pivotIsSound = checkInside(place + ".pivot", rope.pivot, 0);
    const bool lengthIsSound = check(place + ".length", rope.length, kRopeLengthRange);
    const bool angleIsSound = check(place + ".angle", degrees(rope.angle), kRopeAngleRange);
    check(place + ".angularVelocity", degrees(rope.angularVelocity), kAngularVelocityRange);
    return pivotIsSound && lengthIsSound && angleIsSound;
  }

  void checkSolvers() {
    checkCount("solvers", m_scene.solvers.size(), kMostSolvers);
    for (std::size_t i = 0; i < m_scene.solvers.size(); ++i) {
      const std::string place = entry("solvers", i);
      check(place + ".step", m_scene.solvers[i].step, kStepRange);
      check(place + ".tolerance", m_scene.solvers[i].tolerance, kToleranceRange);
    }
  }

  const Scene& m_scene;
  std::vector<Problem> m_problems;
  bool m_roomIsSound = false;
};

/// "1e+09" as a person writes it: "1e9".
std::string withShortExponent(std::string text) {
  const std::size_t mark = text.find('e');
  if (mark == std::string::npos) return text;
  if (text[mark + 1] == '+') text.erase(mark + 1, 1);
  const std::size_t digits = text.find_first_of("0123456789", mark);
  text.erase(digits, text.find_first_not_of('0', digits) - digits);
  return text;
}

}  // namespace

std::vector<Problem> problemsIn(const Scene& scene) {
  return Inspection(scene).problems();
}

std::string numberText(double value) {
  if (value == 0) return "0";  // without the sign a zero may have
  const double size = std::abs(value);
  const bool isPlain = 1e-4 <= size && size < 1e7;
  std::array<char, 32> digits;
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), value,
                    isPlain ? std::chars_format::fixed : std::chars_format::scientific);
  std::string text(digits.data(), end);
  return isPlain ? text : withShortExponent(std::move(text));
}

}  // namespace core
