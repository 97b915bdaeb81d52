#pragma once

#include <QString>

class QPagedPaintDevice;
class QTextDocument;
class QWidget;

namespace ui {

/// Prints a document in the colors it has, with margins, on as many pages as it takes.
/// @pre the document has no page size of its own
void printDocument(const QTextDocument& document, QPagedPaintDevice* paper);

/// Asks which printer, and prints.
/// @param title  how the printer and the dialog call it
/// @return       false if the user thought better of it
bool askAndPrint(const QTextDocument& document, const QString& title, QWidget* window);

/// Writes the pages as a PDF file: whole, or not at all.
/// @return  what went wrong; empty if nothing did
QString writePdf(const QTextDocument& document, const QString& title, const QString& file);

}  // namespace ui
