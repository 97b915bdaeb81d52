#include "ui/chart/chart_heading.h"

#include <algorithm>
#include <utility>

#include <QFontMetricsF>
#include <QPainter>

namespace ui {

namespace {

constexpr int kInRow = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine;
constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
constexpr double kUnlimited = 1e4;
constexpr double kMarkOutline = 2;

// In multiples of the font's size.
constexpr double kTitleSize = 1.2;
constexpr double kRowHeight = 1.35;
constexpr double kCompactRowHeight = 1.2;
constexpr double kTextGap = 0.2;
constexpr double kMarkSize = 0.75;
constexpr double kLineLength = 1.8;
constexpr double kSmallGap = 0.4;
constexpr double kFiguresGap = 0.8;
constexpr double kLargeGap = 1;

}  // namespace

ChartHeading::ChartHeading(QGraphicsItem* parent) : QGraphicsItem(parent) {}

void ChartHeading::setLook(const ChartLook& look) {
  m_look = look;
}

void ChartHeading::setContent(HeadingContent content) {
  m_pieces.clear();  // they point into the content
  m_content = std::move(content);
}

double ChartHeading::layOut(double width, HeadingDensity density, double mostHeight) {
  m_density = density;
  prepareGeometryChange();
  m_pieces.clear();
  m_bounds = QRectF(0, 0, width, 0);
  m_rowEnd = 0;
  QFont titleFont = m_look.font;
  titleFont.setBold(true);
  titleFont.setPixelSize(qRound(kTitleSize * em()));
  placeText(m_content.title, titleFont, m_look.theme.text);
  placeText(m_content.note, m_look.font, m_look.theme.faintText);
  placeLegend(density == HeadingDensity::kCut ? mostHeight : kUnlimited);
  const bool tellsRuns = density == HeadingDensity::kFull || density == HeadingDensity::kCompact;
  if (tellsRuns) placeRuns();
  placeText(m_content.warning, m_look.font, m_look.theme.drift);
  update();
  return m_bounds.height();
}

void ChartHeading::placeText(const QString& text, const QFont& font, const QColor& color) {
  if (text.isEmpty()) return;
  const QRectF space(0, m_bounds.bottom(), m_bounds.width(), kUnlimited);
  QRectF place = QFontMetricsF(font).boundingRect(space, kWrapped, text);
  place.setWidth(m_bounds.width());
  m_pieces.push_back({place, nullptr, text, font, color, kWrapped});
  m_bounds.setBottom(place.bottom() + kTextGap * em());
}

void ChartHeading::beginRow() {
  m_bounds.setBottom(m_bounds.bottom() + rowHeight());
  m_rowEnd = 0;
}

void ChartHeading::placeLegend(double mostHeight) {
  if (!m_content.legend.empty()) beginRow();
  for (const HeadingEntry& entry : m_content.legend) {
    const bool fits = m_rowEnd + widthInOneRow({entry}) <= m_bounds.width();
    if (m_rowEnd > 0 && !fits) {
      if (m_bounds.bottom() + rowHeight() > mostHeight) return placeMore();
      beginRow();
    }
    placeEntry(entry, m_rowEnd + labelWidth(entry));
  }
}

/// In place of all further entries of the legend.
void ChartHeading::placeMore() {
  const QRectF place(m_rowEnd - kLargeGap * em() + kSmallGap * em(),
                     m_bounds.bottom() - rowHeight(), em(), rowHeight());
  m_pieces.push_back({place, nullptr, QStringLiteral("…"), m_look.font, m_look.theme.text, kInRow});
}

void ChartHeading::placeRuns() {
  if (m_content.runs.empty()) return;
  const double width = widthInOneRow(m_content.runs);
  const bool inOneRow = width <= m_bounds.width();
  const double legendWidth = widthInOneRow(m_content.legend) + kLargeGap * em();
  if (m_content.legend.empty() || legendWidth + width > m_bounds.width()) beginRow();

  double widestLabel = 0;
  for (const HeadingEntry& run : m_content.runs) {
    widestLabel = std::max(widestLabel, labelWidth(run));
  }
  for (const HeadingEntry& run : m_content.runs) {
    if (m_rowEnd > 0 && !inOneRow) beginRow();
    placeEntry(run, m_rowEnd + (inOneRow ? labelWidth(run) : widestLabel));
  }
}

void ChartHeading::placeEntry(const HeadingEntry& entry, double figuresX) {
  const auto place = [&](double x, double width) {
    return QRectF(x, m_bounds.bottom() - rowHeight(), width, rowHeight());
  };
  QFont font = m_look.font;
  font.setStrikeOut(entry.hidden);
  const QColor color = entry.hidden ? m_look.theme.faintText : m_look.theme.text;
  const double room = m_bounds.width() - m_rowEnd - symbolWidth(entry);
  const QString label = QFontMetricsF(font).elidedText(labelOf(entry), Qt::ElideRight, room);
  m_pieces.push_back({place(m_rowEnd, labelWidth(entry)), &entry, label, font, color, kInRow});
  if (!entry.figures.isEmpty()) {
    const double needed = QFontMetricsF(m_look.font).horizontalAdvance(entry.figures);
    if (figuresX + needed > m_bounds.width()) {
      beginRow();
      figuresX = std::clamp(m_bounds.width() - needed, 0.0, symbolWidth(entry));
    }
    const QString figures =
        QFontMetricsF(font).elidedText(entry.figures, Qt::ElideRight, m_bounds.width() - figuresX);
    m_pieces.push_back({place(figuresX, figuresWidth(entry)), nullptr, figures, font,
                        entry.hidden ? color : m_look.theme.drift, kInRow});
  }
  m_rowEnd = m_pieces.back().place.right() + kLargeGap * em();
}

double ChartHeading::widthInOneRow(const std::vector<HeadingEntry>& entries) const {
  double width = -kLargeGap * em();
  for (const HeadingEntry& entry : entries) {
    width += labelWidth(entry) + figuresWidth(entry) + kLargeGap * em();
  }
  return width;
}

/// With the gap that parts it from figures.
double ChartHeading::labelWidth(const HeadingEntry& entry) const {
  const QString label = labelOf(entry);
  const double gap = entry.figures.isEmpty() || label.isEmpty() ? 0 : kFiguresGap * em();
  return symbolWidth(entry) + QFontMetricsF(m_look.font).horizontalAdvance(label) + gap;
}

QString ChartHeading::labelOf(const HeadingEntry& entry) const {
  const bool isCompact = m_density == HeadingDensity::kCompact;
  return isCompact && !entry.figures.isEmpty() ? QString() : entry.text;
}

double ChartHeading::figuresWidth(const HeadingEntry& entry) const {
  const QFontMetricsF metrics(m_look.font);
  return std::max(metrics.horizontalAdvance(entry.figures),
                  metrics.horizontalAdvance(entry.widestFigures));
}

double ChartHeading::symbolWidth(const HeadingEntry& entry) const {
  const double mark = entry.mark.isValid() ? kMarkSize + kSmallGap : 0;
  return (mark + kLineLength + kSmallGap) * em();
}

const HeadingEntry* ChartHeading::entryAt(QPointF place) const {
  const auto hit = std::ranges::find_if(m_pieces, [&](const Piece& piece) {
    return piece.entry != nullptr && piece.place.contains(place);
  });
  return hit == m_pieces.end() ? nullptr : hit->entry;
}

void ChartHeading::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  for (const Piece& piece : m_pieces) {
    QRectF place = piece.place;
    if (piece.entry != nullptr) {
      paintSymbol(*painter, piece);
      place.setLeft(place.left() + symbolWidth(*piece.entry));
    }
    // Wider than measured: a painter for paper may set letters a little wider.
    place.setRight(place.right() + em());
    painter->setFont(piece.font);
    painter->setPen(piece.color);
    painter->drawText(place, piece.flags, piece.text);
  }
}

void ChartHeading::paintSymbol(QPainter& painter, const Piece& piece) const {
  const HeadingEntry& entry = *piece.entry;
  double x = piece.place.left();
  const double y = piece.place.center().y();
  if (entry.mark.isValid()) {
    const double radius = kMarkSize / 2 * em();
    painter.setPen(QPen(entry.mark, kMarkOutline));
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
  return (m_density == HeadingDensity::kFull ? kRowHeight : kCompactRowHeight) * em();
}

}  // namespace ui
