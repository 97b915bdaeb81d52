#include "ui/files/scene_file.h"

#include <string_view>

#include <QCoreApplication>
#include <QFile>

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

SceneOrError parse(const QByteArray& text, SceneDemand demand) {
  if (!text.isValidUtf8()) return refused(Texts::tr("not UTF-8"));
  try {
    return {SceneReader(std::string_view(text.constData(), text.size()), demand).read(), {}};
  } catch (const JsonError& error) {
    return refused(Texts::tr("not JSON: %1").arg(error.line));
  } catch (const ValueRefused& refusal) {
    return refused(refusal.line);
  }
}

}  // namespace

SceneOrError parseScene(const QByteArray& text) {
  return parse(text, SceneDemand::kCanRun);
}

SceneOrError parseDraft(const QByteArray& text) {
  return parse(text, SceneDemand::kDraft);
}

SceneOrError readSceneFile(const QString& file) {
  QFile input(file);
  if (!input.open(QIODevice::ReadOnly)) return refused(input.errorString());
  const QByteArray text = input.read(kLargestFile + 1);
  if (input.error() != QFileDevice::NoError) return refused(input.errorString());
  if (text.size() > kLargestFile) return refused(Texts::tr("larger than 64 MiB"));
  return parseScene(text);
}

QByteArray sceneText(const core::Scene& scene) {
  return QByteArray::fromStdString(writtenScene(scene));
}

QString writeSceneFile(const QString& file, const core::Scene& scene) {
  OutputFile output;
  if (output.open(file) && output.write(writtenScene(scene))) output.finish();
  return output.error();
}

}  // namespace ui
