#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include <QCoreApplication>
#include <QString>

#include "core/scene/scene.h"
#include "ui/files/json_cursor.h"

namespace core {
struct Problem;
struct Range;
}  // namespace core

namespace ui {

inline constexpr std::string_view kSceneFormat = "angry-cuts/scene";
inline constexpr int kSceneVersion = 1;

/// Thrown by SceneReader: "weights[3].rope.length: must be a number, got a text".
struct SceneRefused {
  QString line;
};

/// Reads one scene from the text of a scene file, strictly: what is not known, not complete
/// or not allowed is refused, and nothing is corrected.
class SceneReader {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneReader)

 public:
  /// @param text  valid UTF-8, must outlive the reader
  explicit SceneReader(std::string_view text) : m_text(text), m_json(text) {}

  /// @return a scene that can run; throws JsonError or SceneRefused; call once
  core::Scene read();

 private:
  struct Member {
    std::string_view key;
    std::function<void()> read;
  };

  void checkHeader();
  void checkFormat(const std::optional<std::string>& format);
  void checkVersion(std::optional<double> version);
  core::Scene readScene();
  void readRoom(core::Room& room);
  core::Weight readWeight();
  core::Rope readRope();
  core::Solver readSolver();
  std::string readMethod();
  core::Color readColor();
  Eigen::Vector2d readVector();
  double readAngle(const core::Range& allowed);
  double readNumber();
  std::optional<double> readNumberOrNull();
  std::string_view readDigits();
  bool readBoolean();
  std::string readString();

  void readObject(std::initializer_list<Member> members);
  /// Calls `readEntry` for the entries of a list; refuses it unless it has so many.
  void readList(int fewest, int most, const std::function<void()>& readEntry);

  void expect(JsonKind kind);
  [[noreturn]] void refuse(const QString& reason) const;
  [[noreturn]] static void refuse(const core::Problem& problem);

  std::string_view m_text;
  JsonCursor m_json;
  std::string m_place;  // of the value being read, such as "weights[3].rope"
};

}  // namespace ui
