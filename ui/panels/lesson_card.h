#pragma once

#include <QStyledItemDelegate>

namespace ui {

/// Draws a lesson as a card: its picture, its name, its sentence. All cards have one size,
/// which holds the longest sentence.
class LessonCard : public QStyledItemDelegate {
  Q_OBJECT

 public:
  enum Role { kSentence = Qt::UserRole, kName };

  using QStyledItemDelegate::QStyledItemDelegate;

  /// How wide a card must be at least in this type [px].
  static int leastWidth(const QFont& font);
  /// Of the picture on a card so wide [px].
  static QSize pictureSize(int cardWidth);
  /// How high cards so wide must be for all these sentences [px].
  static int heightFor(int cardWidth, const QStringList& sentences, const QFont& font);

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

}  // namespace ui
