#include "ui/files/draft_file.h"

#include <utility>

#include <QDataStream>
#include <QFile>
#include <QFileInfo>

#include "core/system/disk.h"
#include "ui/files/output_file.h"
#include "ui/files/scene_file.h"

namespace ui {
namespace {

constexpr quint32 kMagic = 0x41434472;  // "ACDr"
constexpr quint32 kVersion = 1;

}  // namespace

QString writeDraftFile(const QString& path, const KeptDraft& kept) {
  QByteArray bytes;
  QDataStream stream(&bytes, QIODevice::WriteOnly);
  stream.setVersion(QDataStream::Qt_6_0);
  stream << kMagic << kVersion << kept.file << sceneText(kept.scene)
         << (kept.draft ? sceneText(*kept.draft) : QByteArray());
  const QString error = writeWhole(path, bytes);
  if (error.isEmpty()) {
    core::syncFolder(QFile::encodeName(QFileInfo(path).absolutePath()).toStdString());
  }
  return error;
}

std::optional<KeptDraft> readDraftFile(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
  QDataStream stream(&file);
  stream.setVersion(QDataStream::Qt_6_0);
  quint32 magic = 0;
  quint32 version = 0;
  stream >> magic >> version;
  if (magic != kMagic || version != kVersion) return std::nullopt;
  KeptDraft kept;
  QByteArray sceneBytes;
  QByteArray draftBytes;
  stream >> kept.file >> sceneBytes >> draftBytes;
  SceneOrError scene = parseScene(sceneBytes);
  if (stream.status() != QDataStream::Ok || !scene.scene) return std::nullopt;
  kept.scene = std::move(*scene.scene);
  if (!draftBytes.isEmpty()) kept.draft = parseDraft(draftBytes).scene;
  return kept;
}

}  // namespace ui
