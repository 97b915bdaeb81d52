#pragma once

#include <map>
#include <vector>

#include <QString>

#include "tests/ui/files/lesson_figures.h"

namespace tests {

/// How the figures of a lesson's sheet are worked out, by the lesson's scene.
using FiguresByLesson = std::map<QString, std::vector<LessonFigure> (*)()>;

/// Lessons on what a method and its step do to the answer.
const FiguresByLesson& methodFigures();
/// Lessons on weights that stay on their ropes.
const FiguresByLesson& swingFigures();
/// Lessons on weights that fly and hit something.
const FiguresByLesson& flightFigures();

}  // namespace tests
