#pragma once

#include <memory>

#include <QColor>
#include <QFont>
#include <QObject>
#include <QSizeF>
#include <QTextObjectInterface>

class QPaintDevice;
class QPainter;
class QTextCursor;
class QTextDocument;

namespace ui {

/// What an inline drawing is drawn with.
struct DrawingLook {
  QFont font;                            ///< of the words around it
  QColor color;                          ///< of the words around it
  const QPaintDevice* device = nullptr;  ///< null: the screen
  double room = 0;  ///< width of a line in the document; 0: as wide as it likes
};

/// Something drawn that stands in a line of text like a letter: an equation, a key, an icon.
class InlineDrawing {
 public:
  InlineDrawing() = default;
  InlineDrawing(const InlineDrawing&) = delete;
  InlineDrawing& operator=(const InlineDrawing&) = delete;
  virtual ~InlineDrawing() = default;

  /// Its bottom is the baseline.
  virtual QSizeF size(const DrawingLook& look) const = 0;
  /// @param place  of that size; what goes below the baseline, as tails of letters do, is drawn
  ///               below it
  virtual void draw(QPainter& painter, const QRectF& place, const DrawingLook& look) const = 0;
};

/// Lets a document draw them; on paper, too, in the color of its text.
class InlineDrawings : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  /// @param color  of what is drawn
  InlineDrawings(QTextDocument* document, const QColor& color);

  /// Puts one in, in the font of the text there.
  static void insert(QTextCursor& cursor, std::shared_ptr<const InlineDrawing> drawing);

  QSizeF intrinsicSize(QTextDocument* document, int place, const QTextFormat& format) override;
  void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document, int place,
                  const QTextFormat& format) override;

 private:
  DrawingLook lookOf(const QTextDocument* document, const QTextFormat& format) const;

  QColor m_color;
};

/// An equation as core/model.md writes it, in a sentence.
std::shared_ptr<const InlineDrawing> inlineMath(const QString& text);
/// Lines of equations on a line of their own.
std::shared_ptr<const InlineDrawing> displayedMath(const QStringList& lines);
/// What is written on a key, or on several that are pressed together.
std::shared_ptr<const InlineDrawing> inlineKey(const QString& words);
/// The icon of that name from the window.
std::shared_ptr<const InlineDrawing> inlineIcon(const QString& name);

}  // namespace ui

Q_DECLARE_METATYPE(std::shared_ptr<const ui::InlineDrawing>)
