#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace ui {

/// For askWhereToSave(): the kinds of picture a chart can be.
QStringList pictureKinds();

/// Says in a message that a file was not written; does nothing if there was no error.
void sayIfNotExported(QWidget* window, const QString& file, const QString& error);

}  // namespace ui
