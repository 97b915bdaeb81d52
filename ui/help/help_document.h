#pragma once

#include <memory>

#include <QColor>
#include <QFont>
#include <QString>

class QPalette;
class QTextDocument;

namespace ui {

/// How a page of help looks.
struct PageLook {
  QFont font;
  QColor text;
  QColor faint;          ///< lines of tables
  bool isPaper = false;  ///< set closer

  /// As the window's.
  static PageLook of(const QPalette& palette, const QFont& font);
  /// Black on white, in type for reading.
  static PageLook onPaper();
};

/// What `code` is in a text.
enum class CodeMeans {
  kKeys,  ///< keys to press
  kMath,  ///< equations, as core/model.md writes them; a block of code is a block of equations
};

/// A page of Markdown as a document, with equations and keys drawn, and with the window's own
/// icons where the text has pictures: ![Play](../../icons/play.svg).
std::unique_ptr<QTextDocument> helpDocument(const QString& markdown, CodeMeans code,
                                            const PageLook& look);

}  // namespace ui
