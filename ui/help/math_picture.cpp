#include "ui/help/math_picture.h"

#include <algorithm>
#include <utility>

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QStringList>
#include <QTransform>

#include "ui/help/math_text.h"

namespace ui {
namespace {

// Shares of the type's size.
constexpr double kScriptSize = 0.78;
constexpr double kThinSpace = 0.17;
constexpr double kOperatorSpace = 0.22;
constexpr double kRelationSpace = 0.3;
constexpr double kFractionGap = 0.16;    // between its bar and what is above and below
constexpr double kFractionMargin = 0.1;  // of the bar at both ends
constexpr double kRuleThickness = 0.055;
constexpr double kLowering = 0.22;  // of an index
constexpr double kRaising = 0.42;   // of an exponent
constexpr double kRootWidth = 0.55;
constexpr double kRootGap = 0.12;
constexpr double kLineGap = 0.55;
constexpr double kColumnGap = 2.2;

class Setter {
 public:
  Setter(MathStyle style, const QFont& font, const QPaintDevice* device)
      : m_style(style), m_device(device), m_font(font), m_em(sizeOf(font)) {}

  double em() const { return m_em; }

  MathPicture set(const MathNode& node) const {
    switch (node.kind) {
      case MathKind::kRow:
        return setRow(node.parts);
      case MathKind::kFraction:
        return setFraction(node);
      case MathKind::kRoot:
        return setRoot(node);
      case MathKind::kScripts:
        return setScripts(node);
      case MathKind::kFence:
        return setFence(node);
      case MathKind::kVariable:
        return setWords(node.text, true);
      default:
        return setWords(node.text, false);
    }
  }

  MathPicture setRow(const std::vector<MathNode>& parts) const {
    MathPicture row;
    const MathNode* before = nullptr;
    for (const MathNode& part : parts) {
      if (before) row.width += m_em * spaceBetween(*before, part);
      const MathPicture picture = set(part);
      row.add(picture, {row.width, 0});
      before = &part;
    }
    return row;
  }

 private:
  double sizeOf(const QFont& font) const {
    return QFontInfo(m_device ? QFont(font, m_device) : font).pixelSize();
  }

  QFontMetricsF metrics(const QFont& font) const {
    return m_device ? QFontMetricsF(font, m_device) : QFontMetricsF(font);
  }

  /// For indices and exponents; within them fractions have a slash.
  Setter smaller() const {
    QFont font = m_font;
    font.setPointSizeF(m_font.pointSizeF() * kScriptSize);
    return {MathStyle::kInLine, font, m_device};
  }
  Setter inLine() const { return {MathStyle::kInLine, m_font, m_device}; }

  /// How high the middle of a minus sign is.
  double axis() const {
    return -metrics(m_font).tightBoundingRect(QStringLiteral("−")).center().y();
  }

  static double spaceBetween(const MathNode& left, const MathNode& right) {
    const auto either = [&](MathKind kind) { return left.kind == kind || right.kind == kind; };
    if (either(MathKind::kRelation)) return kRelationSpace;
    if (right.kind == MathKind::kPunctuation || left.kind == MathKind::kSign) return 0;
    if (left.text == QStringLiteral("·") || right.text == QStringLiteral("·"))
      return kThinSpace / 2;
    if (either(MathKind::kOperator)) return kOperatorSpace;
    if (left.kind == MathKind::kPunctuation) return kRelationSpace;
    if (!right.isApart) return 0;
    return either(MathKind::kWord) ? kRelationSpace : kThinSpace;
  }

  MathPicture setWords(const QString& text, bool isSlanted) const {
    QFont font = m_font;
    font.setItalic(isSlanted);
    const QFontMetricsF sizes = metrics(font);
    const QRectF ink = sizes.tightBoundingRect(text);
    MathPicture picture;
    picture.width = sizes.horizontalAdvance(text);
    // A slanted letter leans over its end.
    if (isSlanted) picture.width = std::max(picture.width, ink.right());
    picture.ascent = std::max(-ink.top(), sizes.xHeight());
    picture.descent = std::max(ink.bottom(), 0.0);
    picture.words.push_back({{0, 0}, text, font});
    return picture;
  }

  /// What a bar or a root holds together needs no brackets.
  static const MathNode& withoutBrackets(const MathNode& node) {
    if (node.kind == MathKind::kRow && node.parts.size() == 1)
      return withoutBrackets(node.parts[0]);
    if (node.kind == MathKind::kFence && node.text == QStringLiteral("()")) return node.parts[0];
    return node;
  }

  MathPicture setFraction(const MathNode& node) const {
    if (m_style == MathStyle::kInLine) return setSlashed(node);
    const MathPicture above = inLine().set(withoutBrackets(node.parts[0]));
    const MathPicture below = inLine().set(withoutBrackets(node.parts[1]));
    const double margin = m_em * kFractionMargin, gap = m_em * kFractionGap;
    const double width = std::max(above.width, below.width) + 2 * margin;
    MathPicture picture;
    picture.add(above, {(width - above.width) / 2, -axis() - gap - above.descent});
    picture.add(below, {(width - below.width) / 2, -axis() + gap + below.ascent});
    picture.rules.push_back({{0, -axis(), width, -axis()}, m_em * kRuleThickness});
    picture.width = width;
    return picture;
  }

  MathPicture setSlashed(const MathNode& node) const {
    MathPicture picture = set(node.parts[0]);
    const MathPicture slash = setWords(QStringLiteral("/"), false);
    picture.add(slash, {picture.width, 0});
    picture.add(set(node.parts[1]), {picture.width, 0});
    return picture;
  }

  MathPicture setRoot(const MathNode& node) const {
    const MathPicture inside = set(withoutBrackets(node.parts[0]));
    const double sign = m_em * kRootWidth;
    const double top = -std::max(inside.ascent, metrics(m_font).xHeight()) - m_em * kRootGap;
    const double bottom = inside.descent;
    const double middle = (top + bottom) / 2;
    const double thin = m_em * kRuleThickness;
    MathPicture picture;
    picture.add(inside, {sign + thin, 0});
    picture.width += m_em * kThinSpace / 2;
    const QPointF foot(0.5 * sign, bottom);
    picture.rules.push_back(
        {{QPointF(0.08 * sign, middle + 0.1 * m_em), QPointF(0.25 * sign, middle)}, thin});
    picture.rules.push_back({{QPointF(0.25 * sign, middle), foot}, 1.8 * thin});
    picture.rules.push_back({{foot, QPointF(sign, top)}, thin});
    picture.rules.push_back({{QPointF(sign, top), QPointF(picture.width, top)}, thin});
    picture.ascent = std::max(picture.ascent, -top + thin);
    return picture;
  }

  MathPicture setScripts(const MathNode& node) const {
    MathPicture picture = set(node.parts[0]);
    const Setter small = smaller();
    const MathPicture below = small.set(bare(node.parts[1]));
    const MathPicture above = small.set(bare(node.parts[2]));
    const double end = picture.width + m_em * 0.03;
    const double taller = std::max(0.0, picture.ascent - metrics(m_font).capHeight());
    const double deeper = std::max(0.0, picture.descent - m_em * 0.25);
    picture.add(below, {end, m_em * kLowering + deeper});
    // Primes are as high as they shall be.
    if (!node.text.isEmpty()) picture.add(setWords(node.text, false), {end, -taller});
    const double primes = metrics(m_font).horizontalAdvance(node.text);
    picture.add(above, {end + primes, -m_em * kRaising - taller});
    return picture;
  }

  /// The brackets of a_(b c) belong to the notation.
  static const MathNode& bare(const MathNode& script) {
    return script.parts.size() == 1 ? withoutBrackets(script.parts[0]) : script;
  }

  MathPicture setFence(const MathNode& node) const {
    const MathPicture inside = setRow(node.parts[0].parts);
    const bool isTall = !inside.rules.empty();  // a fraction or a root
    MathPicture picture;
    const auto addSign = [&](QChar sign) {
      picture.add(isTall ? stretched(sign, inside) : setWords(sign, false), {picture.width, 0});
    };
    addSign(node.text[0]);
    picture.add(inside, {picture.width, 0});
    addSign(node.text[1]);
    return picture;
  }

  /// A bracket as tall as what it holds, around the height of the bars of fractions.
  MathPicture stretched(QChar sign, const MathPicture& inside) const {
    const MathPicture usual = setWords(sign, false);
    const double half = std::max(inside.ascent - axis(), inside.descent + axis());
    QPainterPath path;
    // As large as letters, and not as points: paths do not know of the device.
    QFont font = m_font;
    font.setPixelSize(100);
    path.addText(0, 0, font, sign);
    const QRectF ink = path.boundingRect();
    const double across = m_em / 100;
    QTransform place;
    place.translate(0, -axis());
    place.scale(across, 2 * half / ink.height());
    place.translate(0, -ink.center().y());
    MathPicture picture;
    picture.width = usual.width;
    picture.ascent = half + axis();
    picture.descent = half - axis();
    picture.shapes.push_back(place.map(path));
    return picture;
  }

  MathStyle m_style;
  const QPaintDevice* m_device;
  QFont m_font;
  double m_em;
};

/// A line of equations: its columns, and the first one divided before its first relation.
struct MathLine {
  MathPicture left;
  std::vector<MathPicture> columns;

  double ascent() const {
    double most = left.ascent;
    for (const MathPicture& column : columns) most = std::max(most, column.ascent);
    return most;
  }
  double descent() const {
    double most = left.descent;
    for (const MathPicture& column : columns) most = std::max(most, column.descent);
    return most;
  }
};

MathLine setLine(const QString& text, const Setter& setter) {
  static const QRegularExpression kGap(QStringLiteral("\\s{2,}"));
  MathLine line;
  for (const QString& words : text.trimmed().split(kGap)) {
    MathNode row = readMath(words);
    if (line.columns.empty()) {
      const auto relation = std::ranges::find(row.parts, MathKind::kRelation, &MathNode::kind);
      if (relation != row.parts.end()) {
        line.left = setter.setRow({row.parts.begin(), relation});
        line.left.width += setter.em() * kRelationSpace;
        row.parts.erase(row.parts.begin(), relation);
      }
    }
    line.columns.push_back(setter.set(row));
  }
  return line;
}

}  // namespace

void MathPicture::add(const MathPicture& other, QPointF place) {
  for (Words part : other.words) {
    part.place += place;
    words.push_back(std::move(part));
  }
  for (const Rule& rule : other.rules)
    rules.push_back({rule.line.translated(place), rule.thickness});
  for (const QPainterPath& shape : other.shapes) shapes.push_back(shape.translated(place));
  width = std::max(width, place.x() + other.width);
  ascent = std::max(ascent, other.ascent - place.y());
  descent = std::max(descent, other.descent + place.y());
}

void MathPicture::draw(QPainter& painter, QPointF place) const {
  painter.save();
  painter.translate(place);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = painter.pen().color();
  for (const Words& part : words) {
    painter.setFont(part.font);
    painter.drawText(part.place, part.text);
  }
  for (const Rule& rule : rules) {
    painter.setPen(QPen(color, rule.thickness, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawLine(rule.line);
  }
  for (const QPainterPath& shape : shapes) painter.fillPath(shape, color);
  painter.restore();
}

MathPicture mathPicture(const MathNode& math, MathStyle style, const QFont& font,
                        const QPaintDevice* device) {
  return Setter(style, font, device).set(math);
}

MathPicture mathLines(const QStringList& lines, const QFont& font, const QPaintDevice* device) {
  const Setter setter(MathStyle::kDisplay, font, device);
  std::vector<MathLine> set;
  std::vector<double> columnWidths;
  double leftWidth = 0;
  for (const QString& text : lines) {
    const MathLine& line = set.emplace_back(setLine(text, setter));
    leftWidth = std::max(leftWidth, line.left.width);
    columnWidths.resize(std::max(columnWidths.size(), line.columns.size()));
    for (std::size_t i = 0; i < line.columns.size(); ++i)
      columnWidths[i] = std::max(columnWidths[i], line.columns[i].width);
  }
  MathPicture all;
  double bottom = 0;
  for (const MathLine& line : set) {
    const double base = bottom + line.ascent();
    bottom = base + line.descent() + setter.em() * kLineGap;
    all.add(line.left, {leftWidth - line.left.width, base});
    double x = leftWidth;
    for (std::size_t i = 0; i < line.columns.size(); ++i) {
      all.add(line.columns[i], {x, base});
      x += columnWidths[i] + setter.em() * kColumnGap;
    }
  }
  return all;
}

}  // namespace ui
