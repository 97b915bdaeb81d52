#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <QCoreApplication>

#include "core/scene/scene.h"
#include "ui/files/strict_reader.h"

namespace core {
struct Problem;
struct Range;
}  // namespace core

namespace ui {

inline constexpr std::string_view kSceneFormat = "angry-cuts/scene";
inline constexpr int kSceneVersion = 1;

/// What a reader asks of a scene.
enum class SceneDemand {
  kCanRun,  ///< all that a scene file must be
  kDraft    ///< no more than that it can be read: numbers may be anything
};

/// Reads one scene from the text of a scene file, strictly: what is not known, not complete
/// or not allowed is refused, and nothing is corrected.
class SceneReader : private StrictReader {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneReader)

 public:
  /// @param text  valid UTF-8, must outlive the reader
  explicit SceneReader(std::string_view text, SceneDemand demand = SceneDemand::kCanRun)
      : StrictReader(text, "scene"), m_text(text), m_demand(demand) {}

  /// @return a scene that meets the demand; throws JsonError or ValueRefused; call once
  core::Scene read();

 private:
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

  using StrictReader::refuse;
  [[noreturn]] static void refuse(const core::Problem& problem);

  std::string_view m_text;
  SceneDemand m_demand;
};

}  // namespace ui
