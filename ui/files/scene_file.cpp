#include "ui/files/scene_file.h"

#include <string_view>

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include "ui/files/output_file.h"
#include "ui/files/scene_reader.h"
#include "ui/files/scene_writer.h"

namespace ui {

namespace {

constexpr qint64 kLargestFile = qint64{64} << 20;

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(ui::SceneFile)
};

SceneOrError refused(const QString& line) {
  return {std::nullopt, line};
}

bool isUtf16(const QByteArray& text) {
  return text.startsWith("\xFF\xFE") || text.startsWith("\xFE\xFF");
}

SceneOrError parse(const QByteArray& text, SceneDemand demand, const core::Progress& progress) {
  if (text.isEmpty()) return refused(Texts::tr("the file is empty"));
  if (isUtf16(text)) return refused(Texts::tr("not UTF-8 but UTF-16; save it as UTF-8"));
  if (!text.isValidUtf8()) return refused(Texts::tr("not UTF-8"));
  try {
    const std::string_view content(text.constData(), static_cast<std::size_t>(text.size()));
    return {SceneReader(content, demand, progress).read(), {}};
  } catch (const ReadingStopped&) {
    return {};
  } catch (const JsonError& error) {
    return refused(Texts::tr("not JSON: %1").arg(error.line));
  } catch (const ValueRefused& refusal) {
    return refused(refusal.line);
  }
}

}  // namespace

SceneOrError parseScene(const QByteArray& text) {
  return parse(text, SceneDemand::kCanRun, {});
}

SceneOrError parseDraft(const QByteArray& text) {
  return parse(text, SceneDemand::kDraft, {});
}

SceneOrError readSceneFile(const QString& file, const core::Progress& progress) {
  QFile input(file);
  if (!input.open(QIODevice::ReadOnly)) return refused(input.errorString());
  const QByteArray text = input.read(kLargestFile + 1);
  if (input.error() != QFileDevice::NoError) return refused(input.errorString());
  if (text.size() > kLargestFile) return refused(Texts::tr("larger than 64 MiB"));
  return parse(text, SceneDemand::kCanRun, progress);
}

QString obstacleToReading(const QString& file) {
  const QFileInfo info(file);
  const bool isSpecial = info.exists() && !info.isFile() && !info.isDir();
  return isSpecial ? Texts::tr("it is no file but a pipe or a device") : QString();
}

QByteArray sceneText(const core::Scene& scene) {
  return QByteArray::fromStdString(writtenScene(scene));
}

QString writeSceneFile(const QString& file, const core::Scene& scene) {
  return writeWhole(file, writtenScene(scene));
}

}  // namespace ui
