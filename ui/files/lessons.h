#pragma once

#include <vector>

#include <QString>
#include <QStringList>

namespace core {
struct Scene;
}

namespace ui {

/// What a teacher gets along with a built-in scene, in the language of the window.
struct Lesson {
  QString name;        ///< of the scene: words joined by hyphens
  QString title;       ///< the scene's name as it is shown
  QString look;        ///< what to look for: one sentence
  QStringList tries;   ///< what to try: two or three lines
  double pictureTime;  ///< a moment that shows what it is about [s]
};

/// One for each built-in scene, in the order of menus and lists.
std::vector<Lesson> lessons();

/// Name of the built-in scene this one was made from; empty if it is somebody's own. A scene
/// keeps its lesson whatever is changed in it, until it gets another name or description.
QString lessonNameOf(const core::Scene& scene);

/// The scene's name as readers see it: a lesson's in their language, else as it was given.
QString titleOf(const core::Scene& scene);

/// The lesson of the built-in scene of that name.
/// @pre `name` is one of builtInScenes()
Lesson lessonNamed(const QString& name);

}  // namespace ui
