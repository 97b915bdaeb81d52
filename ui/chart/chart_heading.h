#pragma once

#include <cstddef>
#include <vector>

#include <QGraphicsItem>
#include <QPen>
#include <QString>

#include "ui/chart/chart_look.h"

namespace ui {

/// One entry above a chart: a mark or a line as on the chart, what it stands for, and
/// figures that change while a run goes on.
struct HeadingEntry {
  QColor mark;  ///< a disc in this color; not valid: none
  bool markFilled = false;
  QPen line;
  QString text;
  QString figures;
  QString widestFigures;  ///< room kept for them, so that nothing moves when they change
  bool hidden = false;    ///< struck out: the reader has hidden what it stands for
  QString key;            ///< of a legend's entry: the curves it stands for
  std::size_t run = 0;    ///< of a run's entry
};

struct HeadingContent {
  QString title;
  QString note;                      ///< below the title, faint
  QString warning;                   ///< what the reader must know to read the curves right
  std::vector<HeadingEntry> legend;  ///< one after the other, in as many rows as it takes
  std::vector<HeadingEntry> runs;    ///< in one row, or each in its own with aligned figures
};

/// How much room a heading takes.
enum class HeadingDensity {
  kFull,
  kCompact,  ///< rows close together; a run with figures goes by its mark and line alone
  kLegend,   ///< rows close together; curves alone, no runs and no figures
  kCut,      ///< the same, and what has no room is left out, which "…" says
};

/// What stands above the plot: title, legend, figures. A legend of our own because Qt's
/// cuts off words where space is short, and has an entry for each curve.
class ChartHeading : public QGraphicsItem {
 public:
  explicit ChartHeading(QGraphicsItem* parent);

  void setLook(const ChartLook& look);
  void setContent(HeadingContent content);

  /// Breaks rows to fit the width [px] and returns the height they take [px]. To be called
  /// after a change of look or content.
  ///
  /// @param mostHeight  of what kCut leaves, if there is room for one row [px]
  double layOut(double width, HeadingDensity density = HeadingDensity::kFull,
                double mostHeight = 0);

  /// The entry at a place, in coordinates of this item; null: none.
  const HeadingEntry* entryAt(QPointF place) const;

  QRectF boundingRect() const override { return m_bounds; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  /// Something with its place, ready to paint.
  struct Piece {
    QRectF place;
    const HeadingEntry* entry = nullptr;  // whose mark and line stand before the text
    QString text;
    QFont font;
    QColor color;
    int flags = 0;  // of QPainter::drawText
  };

  void placeText(const QString& text, const QFont& font, const QColor& color);
  void placeLegend(double mostHeight);
  void placeMore();
  void placeRuns();
  /// At the end of the last row; the figures in the next one if they do not fit.
  void placeEntry(const HeadingEntry& entry, double figuresX);
  void beginRow();
  QString labelOf(const HeadingEntry& entry) const;
  double labelWidth(const HeadingEntry& entry) const;
  double figuresWidth(const HeadingEntry& entry) const;
  double widthInOneRow(const std::vector<HeadingEntry>& entries) const;
  double symbolWidth(const HeadingEntry& entry) const;
  void paintSymbol(QPainter& painter, const Piece& piece) const;
  double em() const;
  double rowHeight() const;

  ChartLook m_look;
  HeadingContent m_content;
  HeadingDensity m_density = HeadingDensity::kFull;
  std::vector<Piece> m_pieces;
  QRectF m_bounds;
  double m_rowEnd = 0;  // where the last row's next entry may begin [px]
};

}  // namespace ui
