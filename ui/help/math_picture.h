#pragma once

#include <vector>

#include <QFont>
#include <QLineF>
#include <QPainterPath>
#include <QPointF>
#include <QString>

class QPaintDevice;
class QPainter;

namespace ui {

struct MathNode;

/// An equation with all its signs in their places. The baseline is y = 0, y downwards.
struct MathPicture {
  struct Words {
    QPointF place;  ///< left end on the words' own baseline
    QString text;
    QFont font;
  };
  struct Rule {
    QLineF line;
    double thickness;
  };

  double width = 0;
  double ascent = 0;   ///< above the baseline
  double descent = 0;  ///< below it
  std::vector<Words> words;
  std::vector<Rule> rules;
  std::vector<QPainterPath> shapes;  ///< filled

  /// Puts another picture into this one, its left end of the baseline at that place.
  void add(const MathPicture& other, QPointF place);

  /// In the color of the painter's pen.
  void draw(QPainter& painter, QPointF place) const;
};

/// In which way equations are set.
enum class MathStyle {
  kInLine,   ///< within a sentence: fractions with a slash
  kDisplay,  ///< on lines of their own: one above the other
};

/// @param device  whose resolution sizes are for; null: the screen's
MathPicture mathPicture(const MathNode& math, MathStyle style, const QFont& font,
                        const QPaintDevice* device);

/// Lines of equations, one below the other, as in a code block of core/model.md: two spaces and
/// more on a line separate columns, and the lines' first relations stand below each other.
MathPicture mathLines(const QStringList& lines, const QFont& font, const QPaintDevice* device);

}  // namespace ui
