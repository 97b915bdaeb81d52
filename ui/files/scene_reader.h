#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <QCoreApplication>

#include "core/scene/scene.h"
#include "core/trade/work_meter.h"
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

/// Thrown where the progress says to stop.
struct ReadingStopped {};

/// Reads one scene from the text of a scene file, strictly: what is not known, not complete
/// or not allowed is refused, and nothing is corrected.
class SceneReader : private StrictReader {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneReader)

 public:
  /// @param text      valid UTF-8, must outlive the reader
  /// @param progress  told now and then, may be empty
  explicit SceneReader(std::string_view text, SceneDemand demand = SceneDemand::kCanRun,
                       core::Progress progress = {})
      : StrictReader(text, "scene"),
        m_text(text),
        m_demand(demand),
        m_progress(std::move(progress)) {}

  /// @return a scene that meets the demand; throws JsonError, ValueRefused, or ReadingStopped
  ///         where the progress stops it; call once
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

  void showProgress();

  std::string_view m_text;
  SceneDemand m_demand;
  core::Progress m_progress;
};

}  // namespace ui
