#include "ui/help/inline_drawing.h"

#include <algorithm>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QScreen>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>

#include "ui/help/math_picture.h"
#include "ui/help/math_text.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

using DrawingPointer = std::shared_ptr<const InlineDrawing>;

constexpr int kType = QTextFormat::UserObject + 1;
constexpr int kDrawing = QTextFormat::UserProperty + 1;

// Shares of the type's height.
constexpr double kKeyPadding = 0.35;
constexpr double kKeyRounding = 0.2;
constexpr float kKeyShade = 0.12F;
constexpr double kIconSize = 1.2;
constexpr double kIconLowered = 0.15;  // of its own size, below the baseline
constexpr double kDisplaySize = 1.15;
constexpr double kTighter = 0.99;
constexpr int kFittings = 10;

QFontMetricsF metricsOf(const DrawingLook& look) {
  return look.device ? QFontMetricsF(look.font, look.device) : QFontMetricsF(look.font);
}

/// Documents keep their margins in pixels of the screen, whatever they are drawn on.
double pixelsOfScreenOn(const QPaintDevice* device) {
  if (!device) return 1;
  return device->logicalDpiX() / QGuiApplication::primaryScreen()->logicalDotsPerInchX();
}

class InlineMath : public InlineDrawing {
 public:
  explicit InlineMath(const QString& text) : m_math(readMath(text)) {}

  QSizeF size(const DrawingLook& look) const override {
    const MathPicture picture = set(look);
    return {picture.width, picture.ascent};
  }
  void draw(QPainter& painter, const QRectF& place, const DrawingLook& look) const override {
    set(look).draw(painter, place.bottomLeft());
  }

 private:
  MathPicture set(const DrawingLook& look) const {
    return mathPicture(m_math, MathStyle::kInLine, look.font, look.device);
  }

  MathNode m_math;
};

class DisplayedMath : public InlineDrawing {
 public:
  explicit DisplayedMath(QStringList lines) : m_lines(std::move(lines)) {}

  QSizeF size(const DrawingLook& look) const override {
    const MathPicture picture = set(look);
    return {picture.width, picture.ascent + picture.descent};
  }
  void draw(QPainter& painter, const QRectF& place, const DrawingLook& look) const override {
    set(look).draw(painter, place.topLeft());
  }

 private:
  /// Smaller where it would not fit.
  MathPicture set(const DrawingLook& look) const {
    QFont font = look.font;
    font.setPointSizeF(font.pointSizeF() * kDisplaySize);
    MathPicture wanted = mathLines(m_lines, font, look.device);
    // Again and by a little more, as letters may come in some sizes only.
    for (int i = 0; i < kFittings && look.room > 0 && wanted.width > look.room; ++i) {
      font.setPointSizeF(font.pointSizeF() * kTighter * look.room / wanted.width);
      wanted = mathLines(m_lines, font, look.device);
    }
    return wanted;
  }

  QStringList m_lines;
};

class InlineKey : public InlineDrawing {
 public:
  explicit InlineKey(QString words) : m_words(std::move(words)) {}

  QSizeF size(const DrawingLook& look) const override {
    const QFontMetricsF sizes = metricsOf(look);
    return {sizes.horizontalAdvance(m_words) + 2 * kKeyPadding * sizes.ascent(), sizes.ascent()};
  }
  void draw(QPainter& painter, const QRectF& place, const DrawingLook& look) const override {
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF key = place.adjusted(0, 0, 0, metricsOf(look).descent());
    const double height = key.height();
    QColor shade = look.color;
    shade.setAlphaF(kKeyShade);
    QColor edge = look.color;
    edge.setAlphaF(4 * kKeyShade);
    painter.setPen(QPen(edge, height / 24));
    painter.setBrush(shade);
    const double inset = height / 24;
    painter.drawRoundedRect(key.adjusted(inset, inset, -inset, -inset), kKeyRounding * height,
                            kKeyRounding * height);
    painter.setPen(look.color);
    painter.setFont(look.font);
    painter.drawText(key, Qt::AlignCenter, m_words);
  }

 private:
  QString m_words;
};

class InlineIcon : public InlineDrawing {
 public:
  explicit InlineIcon(const QString& name) : m_name(name) {}

  QSizeF size(const DrawingLook& look) const override {
    // No higher than letters, lest it move the line.
    const double letters = metricsOf(look).ascent();
    return {kIconSize * letters, letters};
  }
  void draw(QPainter& painter, const QRectF& place, const DrawingLook& look) const override {
    QRectF square(0, 0, place.width(), place.width());
    square.moveBottomLeft(place.bottomLeft() + QPointF(0, kIconLowered * place.width()));
    drawIcon(painter, m_name, square, look.color);
  }

 private:
  QString m_name;
};

}  // namespace

InlineDrawings::InlineDrawings(QTextDocument* document, const QColor& color)
    : QObject(document), m_color(color) {
  document->documentLayout()->registerHandler(kType, this);
}

void InlineDrawings::insert(QTextCursor& cursor, const DrawingPointer& drawing) {
  QTextCharFormat format = cursor.charFormat();
  format.setObjectType(kType);
  format.setProperty(kDrawing, QVariant::fromValue(drawing));
  cursor.insertText(QString(QChar::ObjectReplacementCharacter), format);
}

DrawingLook InlineDrawings::lookOf(const QTextDocument* document, const QTextFormat& format) const {
  QFont font = document->defaultFont();
  const QTextCharFormat letters = format.toCharFormat();
  font.setBold(letters.fontWeight() > QFont::Medium);
  const QPaintDevice* device = document->documentLayout()->paintDevice();
  const QTextFrameFormat page = document->rootFrame()->frameFormat();
  const double margins = page.leftMargin() + page.rightMargin() + 2 * document->documentMargin();
  return {font, m_color, device, document->textWidth() - margins * pixelsOfScreenOn(device)};
}

QSizeF InlineDrawings::intrinsicSize(QTextDocument* document, int, const QTextFormat& format) {
  const auto drawing = format.property(kDrawing).value<DrawingPointer>();
  return drawing ? drawing->size(lookOf(document, format)) : QSizeF();
}

void InlineDrawings::drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document, int,
                                const QTextFormat& format) {
  const auto drawing = format.property(kDrawing).value<DrawingPointer>();
  if (!drawing) return;
  painter->save();
  painter->setPen(m_color);
  drawing->draw(*painter, rect, lookOf(document, format));
  painter->restore();
}

DrawingPointer inlineMath(const QString& text) {
  return std::make_shared<InlineMath>(text);
}
DrawingPointer displayedMath(const QStringList& lines) {
  return std::make_shared<DisplayedMath>(lines);
}
DrawingPointer inlineKey(const QString& words) {
  return std::make_shared<InlineKey>(words);
}
DrawingPointer inlineIcon(const QString& name) {
  return std::make_shared<InlineIcon>(name);
}

}  // namespace ui
