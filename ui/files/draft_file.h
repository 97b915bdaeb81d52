#pragma once

#include <optional>

#include <QString>

#include "core/scene/scene.h"

namespace ui {

/// What was being edited and is not saved.
struct KeptDraft {
  QString file;                      ///< where the scene belongs; empty: nowhere yet
  core::Scene scene;                 ///< the last one that could run
  std::optional<core::Scene> draft;  ///< what was made of it that cannot run
};

/// Writes it whole or not at all, and so that it outlasts a power cut.
/// @pre all numbers are finite
/// @return empty, or what went wrong in words
QString writeDraftFile(const QString& path, const KeptDraft& kept);

/// Nothing where the file holds no draft, or one of a newer program.
std::optional<KeptDraft> readDraftFile(const QString& path);

}  // namespace ui
