#pragma once

class QString;
class QWidget;

namespace ui {

/// Says in a dialog what went wrong. Names of files and scenes may stand in the words: nothing
/// in them is taken for markup, which could make Qt open files.
void warn(QWidget* window, const QString& title, const QString& words);

}  // namespace ui
