#include "ui/panels/lesson_card.h"

#include <algorithm>

#include <QPainter>
#include <QPalette>

#include "ui/style/theme.h"

namespace ui {
namespace {

constexpr int kGap = 6;                 // around a card [px]
constexpr int kEdge = 10;               // inside it [px]
constexpr int kCharacters = 28;         // that a line of a sentence holds at least
constexpr double kPictureShape = 0.52;  // height / width

QRect insideOf(const QRect& cell) {
  return cell.adjusted(kGap, kGap, -kGap, -kGap).adjusted(kEdge, kEdge, -kEdge, -kEdge);
}

QFont bold(const QFont& font) {
  QFont changed = font;
  changed.setBold(true);
  return changed;
}

void paintCard(QPainter& painter, const QStyleOptionViewItem& option) {
  const bool chosen = option.state.testFlag(QStyle::State_Selected);
  const bool under = option.state.testFlag(QStyle::State_MouseOver);
  const QColor edge =
      option.palette.color(chosen || under ? QPalette::Highlight : QPalette::PlaceholderText);
  // Thicker where the arrow keys would move it.
  const double width = !chosen ? 1 : option.state.testFlag(QStyle::State_HasFocus) ? 5 : 2;
  const QRectF card = QRectF(option.rect).adjusted(kGap, kGap, -kGap, -kGap);
  painter.setPen(QPen(edge, width));
  painter.setBrush(option.palette.color(QPalette::Base));
  painter.drawRoundedRect(card.adjusted(width / 2, width / 2, -width / 2, -width / 2), 6, 6);
}

}  // namespace

int LessonCard::leastWidth(const QFont& font) {
  return kCharacters * QFontMetrics(font).averageCharWidth() + 2 * (kGap + kEdge);
}

QSize LessonCard::pictureSize(int cardWidth) {
  const int width = cardWidth - 2 * (kGap + kEdge);
  return {width, static_cast<int>(width * kPictureShape)};
}

int LessonCard::heightFor(int cardWidth, const QStringList& sentences, const QFont& font) {
  const QSize picture = pictureSize(cardWidth);
  int words = 0;
  for (const QString& sentence : sentences) {
    const QRect room(0, 0, picture.width(), 10000);
    words =
        std::max(words, QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, sentence).height());
  }
  const int title = QFontMetrics(bold(font)).height();
  return picture.height() + kEdge + title + words + kEdge / 2 + 2 * (kGap + kEdge);
}

void LessonCard::paint(QPainter* painter, const QStyleOptionViewItem& option,
                       const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  paintCard(*painter, option);
  const QRect inside = insideOf(option.rect);
  const QRect picture(inside.topLeft(), pictureSize(option.rect.width()));
  const auto image = index.data(Qt::DecorationRole).value<QImage>();
  if (!image.isNull()) painter->drawImage(picture, image);

  const QFont titleFont = bold(option.font);
  const QFontMetrics titleMetrics(titleFont);
  const int titleTop = picture.bottom() + kEdge;
  painter->setPen(option.palette.color(QPalette::Text));
  painter->setFont(titleFont);
  const QRect titleRect(inside.left(), titleTop, inside.width(), titleMetrics.height());
  const QString title = index.data(Qt::DisplayRole).toString();
  painter->drawText(titleRect, Qt::AlignLeft | Qt::AlignVCenter,
                    titleMetrics.elidedText(title, Qt::ElideRight, inside.width()));
  painter->setFont(option.font);
  painter->drawText(inside.adjusted(0, titleRect.bottom() + kEdge / 2 - inside.top(), 0, 0),
                    Qt::TextWordWrap, index.data(kSentence).toString());
  painter->restore();
}

}  // namespace ui
