#include "ui/control/scene_files.h"

#include <numbers>
#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "core/scene/arrangement.h"
#include "ui/control/file_dialog.h"
#include "ui/control/first_scene.h"
#include "ui/control/problem_words.h"
#include "ui/control/recent_files.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_loading.h"
#include "ui/control/warning.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"

namespace ui {
namespace {

// The longer ending comes first: by it desktops know a scene, and .json is everybody's.
const QString kEnding = QStringLiteral(".angrycuts.json");
constexpr double kFirstAngle = std::numbers::pi / 3;  // rad: hanging straight down is no start

core::Scene newScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 1);
  scene.weights.front().rope->angle = kFirstAngle;
  return scene;
}

}  // namespace

SceneFiles::SceneFiles(SceneEditor* editor, const QString& file, QWidget* window)
    : QObject(window), m_editor(editor), m_window(window) {
  editor->setSavedAs(file);
  connect(editor, &SceneEditor::fileChanged, this, &SceneFiles::remember);
  connect(editor, &SceneEditor::sceneReplaced, this, &SceneFiles::remember);
  remember();
}

void SceneFiles::remember() {
  RecentFiles::add(file());
  rememberScene(file(), *m_editor->scene());
}

const QString& SceneFiles::file() const {
  return m_editor->file();
}

bool SceneFiles::mayLeaveScene() {
  if (!m_editor->isModified()) return true;
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("The scene has changes that are not saved. Save them?"),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
  if (!m_editor->problems().empty()) {
    question.setInformativeText(
        tr("What could not be applied is not saved: %1").arg(problemWords(m_editor->problems())));
  }
  switch (question.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void SceneFiles::startNew() {
  if (mayLeaveScene()) m_editor->replace(newScene(), {}, [] { return tr("start of a new scene"); });
}

void SceneFiles::askAndOpen() {
  if (!mayLeaveScene()) return;
  const QString chosen = QFileDialog::getOpenFileName(m_window, tr("Open scene"), file(),
                                                      tr("Scenes (*.json);;All files (*)"));
  if (!chosen.isEmpty()) open(chosen);
}

void SceneFiles::openBuiltIn(const QString& name) {
  if (!mayLeaveScene()) return;
  m_editor->replace(builtInScene(name), {},
                    openingWords([name] { return lessonNamed(name).title; }));
}

void SceneFiles::leaveAndOpen(const QString& file) {
  if (mayLeaveScene()) open(file);
}

void SceneFiles::open(const QString& file) {
  SceneOrError read = readForWindow(file, m_window);
  if (!read.error.isEmpty()) warnNotOpened(file, read.error);
  if (!read.scene) return;
  m_editor->replace(std::move(*read.scene), file, openingWords(QFileInfo(file).fileName()));
}

void SceneFiles::warnNotOpened(const QString& file, const QString& reason) {
  warn(m_window, tr("Scene not opened"),
       tr("%1 was not opened:\n%2").arg(QFileInfo(file).fileName(), reason));
}

Words SceneFiles::openingWords(const Words& name) {
  return [name] { return tr("opening of %1").arg(name.text()); };
}

bool SceneFiles::save() {
  return file().isEmpty() ? saveAs() : saveTo(file());
}

bool SceneFiles::saveAs() {
  const QString name = titleOf(*m_editor->scene());
  const QString suggested = file().isEmpty() ? fileNameFrom(name) + kEnding : file();
  const QString chosen = askWhereToSave(m_window, tr("Save scene"), suggested,
                                        {tr("Scene (*%1 *.json)").arg(kEnding)});
  return !chosen.isEmpty() && saveTo(chosen);
}

bool SceneFiles::saveTo(const QString& file) {
  const QString error = writeSceneFile(file, *m_editor->scene());
  if (!error.isEmpty()) {
    warn(m_window, tr("Scene not saved"),
         tr("%1 was not saved:\n%2").arg(QFileInfo(file).fileName(), error));
    return false;
  }
  m_editor->setSavedAs(file);
  emit done(tr("Saved %1").arg(QDir::toNativeSeparators(file)));
  return true;
}

}  // namespace ui
