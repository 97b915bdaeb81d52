// The reader of scene files, and of drafts that need not be able to run.

#include <functional>

#include <QByteArray>

#include "core/scene/scene_limits.h"
#include "tests/fuzz/target.h"
#include "ui/files/scene_file.h"

namespace {

using Reader = std::function<ui::SceneOrError(const QByteArray&)>;

/// A text is either refused with one line, or means a scene that is written and read unchanged.
std::string faultIn(const ui::SceneOrError& result, const Reader& read) {
  if (!result.scene) {
    if (result.error.isEmpty()) return "refused without a reason";
    return result.error.contains('\n') ? "a reason of several lines" : "";
  }
  if (!result.error.isEmpty()) return "both a scene and a reason to refuse it";
  const QByteArray written = ui::sceneText(*result.scene);
  const ui::SceneOrError again = read(written);
  if (!again.scene) return "refuses what it wrote: " + again.error.toStdString();
  if (*again.scene != *result.scene) return "another scene after writing and reading";
  return ui::sceneText(*again.scene) == written ? "" : "another text after writing and reading";
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const QByteArray text(reinterpret_cast<const char*>(data), static_cast<qsizetype>(size));
  const ui::SceneOrError result = ui::parseScene(text);
  tests::endAt(faultIn(result, ui::parseScene));
  if (result.scene && !core::problemsIn(*result.scene).empty()) tests::endAt("cannot run");
  tests::endAt(faultIn(ui::parseDraft(text), ui::parseDraft));
  return 0;
}

std::string tests::meaningOf(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), bytes.end()};
}
