#include "ui/chart/chart_heading.h"

#include <algorithm>
#include <utility>

#include <QFontMetricsF>
#include <QPainter>

namespace ui {

namespace {

constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

// In multiples of the font's size.
constexpr double kRowHeight = 1.45;
constexpr double kMarkSize = 0.75;
constexpr double kLineLength = 2.1;
constexpr double kSmallGap = 0.4;
constexpr double kLargeGap = 1.3;

}  // namespace

ChartHeading::ChartHeading(QGraphicsItem* parent) : QGraphicsItem(parent) {}

void ChartHeading::setLook(const ChartLook& look) {
  m_look = look;
}

void ChartHeading::setContent(HeadingContent content) {
  m_pieces.clear();  // they point into the content
  m_content = std::move(content);
}

double ChartHeading::layOut(double width) {
  prepareGeometryChange();
  m_pieces.clear();
  m_bounds = QRectF(0, 0, width, 0);
  QFont titleFont = m_look.font;
  titleFont.setBold(true);
  titleFont.setPixelSize(qRound(1.2 * em()));
  placeText(m_content.title, titleFont, m_look.theme.text);
  placeText(m_content.note, m_look.font, m_look.theme.faintText);
  placeGroups();
  placeText(m_content.warning, m_look.font, m_look.theme.drift);
  update();
  return m_bounds.height();
}

void ChartHeading::placeText(const QString& text, const QFont& font, const QColor& color) {
  if (text.isEmpty()) return;
  const QRectF space(0, m_bounds.bottom(), m_bounds.width(), 1e4);
  QRectF place = QFontMetricsF(font).boundingRect(space, kWrapped, text);
  place.setWidth(m_bounds.width());
  m_pieces.push_back({place, nullptr, text, font, color});
  m_bounds.setBottom(place.bottom() + kSmallGap * em() / 2);
}

void ChartHeading::placeGroups() {
  const bool oneRow = widthInOneRow() <= m_bounds.width();
  double x = 0;
  double y = m_bounds.bottom();
  for (const std::vector<HeadingEntry>& group : m_content.groups) {
    if (x > 0 && !oneRow) {
      x = 0;
      y += rowHeight();
    }
    for (const HeadingEntry& entry : group) {
      for (Piece& piece : piecesOf(entry)) {
        if (x > 0 && x + piece.place.width() > m_bounds.width()) {
          x = 0;
          y += rowHeight();
        }
        piece.place.moveTo(x, y);
        x = piece.place.right() + kSmallGap * em();
        m_pieces.push_back(piece);
      }
      x += (kLargeGap - kSmallGap) * em();
    }
  }
  m_bounds.setBottom(x > 0 ? y + rowHeight() : y);
}

std::vector<ChartHeading::Piece> ChartHeading::piecesOf(const HeadingEntry& entry) const {
  const QFontMetricsF metrics(m_look.font);
  const double textWidth = symbolWidth(entry) + metrics.horizontalAdvance(entry.text);
  std::vector<Piece> pieces = {
      {QRectF(0, 0, textWidth, rowHeight()), &entry, entry.text, m_look.font, m_look.theme.text}};
  if (!entry.figures.isEmpty()) {
    const double width = std::max(metrics.horizontalAdvance(entry.figures),
                                  metrics.horizontalAdvance(entry.widestFigures));
    pieces.push_back({QRectF(0, 0, width, rowHeight()), nullptr, entry.figures, m_look.font,
                      m_look.theme.drift});
  }
  return pieces;
}

double ChartHeading::widthInOneRow() const {
  double width = -kLargeGap * em();
  for (const std::vector<HeadingEntry>& group : m_content.groups) {
    for (const HeadingEntry& entry : group) {
      for (const Piece& piece : piecesOf(entry)) width += piece.place.width() + kSmallGap * em();
      width += (kLargeGap - kSmallGap) * em();
    }
  }
  return width;
}

double ChartHeading::symbolWidth(const HeadingEntry& entry) const {
  const double mark = entry.mark.isValid() ? kMarkSize + kSmallGap : 0;
  return (mark + kLineLength + kSmallGap) * em();
}

void ChartHeading::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  for (const Piece& piece : m_pieces) {
    QRectF place = piece.place;
    if (piece.entry != nullptr) {
      paintSymbol(*painter, piece);
      place.setLeft(place.left() + symbolWidth(*piece.entry));
    }
    // A pixel more than measured: a painter for paper may place letters a little wider.
    place.setRight(place.right() + em());
    const bool flows = piece.place.height() == rowHeight();
    painter->setFont(piece.font);
    painter->setPen(piece.color);
    painter->drawText(place,
                      flows ? Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine : kWrapped,
                      piece.text);
  }
}

void ChartHeading::paintSymbol(QPainter& painter, const Piece& piece) const {
  const HeadingEntry& entry = *piece.entry;
  double x = piece.place.left();
  const double y = piece.place.center().y();
  if (entry.mark.isValid()) {
    const double radius = kMarkSize / 2 * em();
    painter.setPen(QPen(entry.mark, 2));
    painter.setBrush(entry.markFilled ? QBrush(entry.mark) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QPointF(x + radius, y), radius - 1, radius - 1);
    x += (kMarkSize + kSmallGap) * em();
  }
  painter.setPen(entry.line);
  painter.drawLine(QPointF(x, y), QPointF(x + kLineLength * em(), y));
}

double ChartHeading::em() const {
  return m_look.font.pixelSize();
}

double ChartHeading::rowHeight() const {
  return kRowHeight * em();
}

}  // namespace ui
