#pragma once

#include <QString>
#include <QStringList>

namespace ui {

/// Texts too long for a table of translations: Markdown files, a folder for each language below
/// `resources/<kind>/`. Kinds are "lessons", the teacher's sheets, and "help".

/// Languages that have a folder: "en" and others, by their codes.
QStringList languagesOf(const QString& kind);

/// The text as it stands in the file; empty if that language does not have it.
QString longText(const QString& kind, const QString& name, const QString& language);

/// The text in the language of the window, else in English.
/// @pre there is an English one
QString longText(const QString& kind, const QString& name);

}  // namespace ui
