#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace ui {

/// Asks where to save; what is typed without an ending gets the one of the chosen kind.
///
/// @param kinds  such as "PNG picture (*.png)", the first one offered
/// @return       empty if the user thought better of it
QString askWhereToSave(QWidget* window, const QString& title, const QString& suggestedFile,
                       const QStringList& kinds);

/// The words as part of a file's name: nothing in it that a file system could refuse.
QString fileNameFrom(const QString& words);

}  // namespace ui
