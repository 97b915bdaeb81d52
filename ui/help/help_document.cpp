#include "ui/help/help_document.h"

#include <utility>
#include <vector>

#include <QPalette>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>

#include "ui/help/inline_drawing.h"

namespace ui {
namespace {

using Drawing = std::shared_ptr<const InlineDrawing>;

constexpr double kPaperType = 12;      // pt
constexpr double kCellPadding = 0.35;  // of the type's size

/// Room between lines and paragraphs, in shares of the type's size.
struct Spacing {
  double lines;  ///< %
  double paragraphs;
  double items;
  double headings;  ///< above them
  double title;     ///< its size
  double heading;
  double indent;  ///< of lists
};

constexpr Spacing kOnScreen{115, 0.6, 0.3, 1.1, 1.6, 1.2, 2};
/// A sheet is one page, in languages that need more words, too.
constexpr Spacing kOnPaper{100, 0.35, 0.12, 0.6, 1.35, 1.1, 1.5};

// Around the number of a drawing while its place is kept in the text: signs nobody writes.
constexpr QChar kBefore(0xE000);
constexpr QChar kAfter(0xE001);

/// Takes what is to be drawn out of a text and leaves a mark in each place.
class Marker {
 public:
  explicit Marker(CodeMeans code) : m_code(code) {}

  QString mark(const QString& markdown) {
    QStringList kept, block;
    for (const QString& line : markdown.split('\n')) {
      const bool isIndented = line.startsWith(QStringLiteral("    "));
      if (m_code == CodeMeans::kMath && isIndented) {
        block << line;
        continue;
      }
      if (!block.isEmpty()) {
        // A paragraph of its own.
        kept << QString() << markFor(displayedMath(block)) << QString();
        block.clear();
      }
      kept << markInLine(line);
    }
    return kept.join('\n');
  }

  const std::vector<Drawing>& drawings() const { return m_drawings; }

 private:
  QString markFor(Drawing drawing) {
    m_drawings.push_back(std::move(drawing));
    return kBefore + QString::number(m_drawings.size() - 1) + kAfter;
  }

  QString markInLine(QString line) {
    static const QRegularExpression kPicture(
        QStringLiteral("!\\[[^\\]]*\\]\\([^)]*/([\\w-]+)\\.svg\\)"));
    static const QRegularExpression kCode(QStringLiteral("`([^`]+)`"));
    replaceAll(line, kPicture, inlineIcon);
    replaceAll(line, kCode, [this](QString text) {
      text.replace(QStringLiteral("\\|"), QStringLiteral("|"));  // in tables
      return m_code == CodeMeans::kMath ? inlineMath(text) : inlineKey(text);
    });
    return line;
  }

  template <class Make>
  void replaceAll(QString& line, const QRegularExpression& what, Make make) {
    for (auto match = what.match(line); match.hasMatch(); match = what.match(line))
      line.replace(match.capturedStart(), match.capturedLength(), markFor(make(match.captured(1))));
  }

  CodeMeans m_code;
  std::vector<Drawing> m_drawings;
};

void draw(QTextDocument& document, const std::vector<Drawing>& drawings) {
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    QTextCursor cursor = document.find(kBefore + QString::number(i) + kAfter);
    if (cursor.isNull()) continue;
    cursor.removeSelectedText();
    InlineDrawings::insert(cursor, drawings[i]);
  }
}

/// Markdown's own formats leave no air between paragraphs and items.
void space(QTextDocument& document, const Spacing& spacing, double type) {
  document.setIndentWidth(spacing.indent * type);
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    QTextCursor cursor(block);
    QTextBlockFormat format = block.blockFormat();
    const int level = format.headingLevel();
    const bool isItem = block.textList();
    const bool isInTable = cursor.currentTable();
    format.setLineHeight(spacing.lines, QTextBlockFormat::ProportionalHeight);
    format.setTopMargin(level > 1 ? spacing.headings * type : 0);
    const double gap = isInTable ? 0 : isItem ? spacing.items : spacing.paragraphs;
    format.setBottomMargin((level > 0 ? spacing.items : gap) * type);
    cursor.setBlockFormat(format);
    if (level == 0) continue;
    cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    QTextCharFormat letters;  // a new one: Markdown's headings are huge
    letters.setFontPointSize(document.defaultFont().pointSizeF() *
                             (level == 1 ? spacing.title : spacing.heading));
    letters.setFontWeight(QFont::Bold);
    cursor.setCharFormat(letters);
  }
}

void drawTables(QTextDocument& document, const PageLook& look, double type) {
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (!table) continue;
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorder(1);
    format.setBorderBrush(look.faint);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setCellPadding(kCellPadding * type);
    format.setCellSpacing(0);
    table->setFormat(format);
  }
}

}  // namespace

PageLook PageLook::of(const QPalette& palette, const QFont& font) {
  QColor faint = palette.color(QPalette::Text);
  faint.setAlphaF(0.35F);
  return {font, palette.color(QPalette::Text), faint, false};
}

PageLook PageLook::onPaper() {
  QFont font;
  font.setPointSizeF(kPaperType);
  return {font, Qt::black, Qt::gray, true};
}

std::unique_ptr<QTextDocument> helpDocument(const QString& markdown, CodeMeans code,
                                            const PageLook& look) {
  auto document = std::make_unique<QTextDocument>();
  document->setUndoRedoEnabled(false);
  document->setDefaultFont(look.font);
  new InlineDrawings(document.get(), look.text);
  Marker marker(code);
  document->setMarkdown(marker.mark(markdown), QTextDocument::MarkdownDialectGitHub);
  const double type = look.font.pointSizeF() * 96 / 72;  // Qt scales margins to the device
  space(*document, look.isPaper ? kOnPaper : kOnScreen, type);
  drawTables(*document, look, type);
  draw(*document, marker.drawings());
  return document;
}

}  // namespace ui
