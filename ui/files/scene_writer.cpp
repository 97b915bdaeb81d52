#include "ui/files/scene_writer.h"

#include <cstdio>
#include <string_view>

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/scene/scene_limits.h"
#include "ui/files/degree_text.h"
#include "ui/files/scene_reader.h"

namespace ui {

namespace {

using core::numberText;

std::string jsonString(std::string_view text) {
  std::string json = "\"";
  for (const char character : text) {
    if (character == '"' || character == '\\') {
      json += '\\';
      json += character;
    } else if (static_cast<unsigned char>(character) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(character));
      json += escape;
    } else {
      json += character;
    }
  }
  return json + '"';
}

std::string vectorText(const Eigen::Vector2d& vector) {
  return '[' + numberText(vector.x()) + ", " + numberText(vector.y()) + ']';
}

std::string colorText(const core::Color& color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
  return text;
}

std::string roomText(const core::Room& room) {
  return "{\"width\": " + numberText(room.width) + ", \"height\": " + numberText(room.height) +
         ", \"restitution\": " + numberText(room.restitution) +
         ", \"friction\": " + numberText(room.friction) + '}';
}

std::string ropeText(const core::Rope& rope) {
  return "{\"pivot\": " + vectorText(rope.pivot) + ", \"length\": " + numberText(rope.length) +
         ", \"angle\": " + degreeText(rope.angle) +
         ", \"angularVelocity\": " + degreeText(rope.angularVelocity) +
         ", \"rigid\": " + (rope.rigid ? "true" : "false") + '}';
}

std::string weightText(const core::Weight& weight) {
  std::string text = "{\"mass\": " + numberText(weight.mass) +
                     ", \"radius\": " + numberText(weight.radius) +
                     ", \"dragCoefficient\": " + numberText(weight.dragCoefficient);
  if (weight.color) text += ", \"color\": " + jsonString(colorText(*weight.color));
  if (weight.rope) return text + ",\n     \"rope\": " + ropeText(*weight.rope) + '}';
  return text + ",\n     \"position\": " + vectorText(weight.position) +
         ", \"velocity\": " + vectorText(weight.velocity) + '}';
}

std::string solverText(const core::Solver& solver) {
  const bool isAdaptive = core::findMethod(solver.method)->isAdaptive;
  return "{\"method\": " + jsonString(solver.method) +
         (isAdaptive ? ", \"tolerance\": " + numberText(solver.tolerance)
                     : ", \"step\": " + numberText(solver.step)) +
         '}';
}

template <class Entries, class TextOf>
std::string listText(const Entries& entries, TextOf textOf) {
  if (entries.empty()) return "[]";
  std::string text = "[\n";
  for (const auto& entry : entries) text += "    " + textOf(entry) + ",\n";
  text.resize(text.size() - 2);  // no comma behind the last
  return text + "\n  ]";
}

}  // namespace

std::string writtenScene(const core::Scene& scene) {
  std::string text = "{\n";
  const auto add = [&text](std::string_view key, const std::string& value) {
    text += "  " + jsonString(key) + ": " + value + ",\n";
  };
  add("format", jsonString(kSceneFormat));
  add("version", std::to_string(kSceneVersion));
  add("name", jsonString(scene.name));
  add("description", jsonString(scene.description));
  add("gravity", numberText(scene.gravity));
  add("airDensity", numberText(scene.airDensity));
  add("room", roomText(scene.room));
  add("restitution", numberText(scene.restitution));
  add("cutTime", scene.cutTime ? numberText(*scene.cutTime) : "null");
  if (!scene.solvers.empty()) add("solvers", listText(scene.solvers, solverText));
  text += "  \"weights\": " + listText(scene.weights, weightText) + "\n}\n";
  return text;
}

}  // namespace ui
