#include "ui/help/math_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ui {
namespace {

const QString kRaised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿ");
const QString kRaisedMeans = QStringLiteral("0123456789+−n");
const QString kLowered = QStringLiteral("₀₁₂₃₄₅₆₇₈₉ₙ");
const QString kLoweredMeans = QStringLiteral("0123456789n");
const QString kOperators = QStringLiteral("+−·×");
const QString kRelations = QStringLiteral("=≥≤<>→≈∼");
const QString kOpening = QStringLiteral("([");
const QString kClosing = QStringLiteral(")]");

/// Reads from left to right; each function leaves the place behind what it has read.
class Reader {
 public:
  explicit Reader(const QString& text) : m_text(text) {}

  MathNode readAll() {
    MathNode all = readRow({});
    while (!atEnd()) {  // a bracket nobody opened
      all.parts.push_back({MathKind::kUpright, m_text[m_place++], {}});
      for (MathNode& part : readRow({}).parts) all.parts.push_back(std::move(part));
    }
    return all;
  }

 private:
  bool atEnd() const { return m_place >= m_text.size(); }
  QChar next() const { return atEnd() ? QChar() : m_text[m_place]; }

  void skipSpaces() {
    while (next() == ' ') ++m_place;
  }

  /// Up to `end`, which is not read; null: to the end of the text.
  MathNode readRow(QChar end) {
    MathNode row;
    for (skipSpaces(); !atEnd() && next() != end && !kClosing.contains(next()); skipSpaces()) {
      if (next() == '/') {
        readFraction(row);
      } else {
        const bool isApart = m_place > 0 && m_text[m_place - 1] == ' ';
        row.parts.push_back(readPart(row));
        row.parts.back().isApart = isApart;
      }
    }
    return row;
  }

  void readFraction(MathNode& row) {
    const bool isWide = m_place > 0 && m_text[m_place - 1] == ' ';
    ++m_place;
    skipSpaces();
    auto first = row.parts.end();
    const auto isInside = [](const MathNode& part) {
      return part.kind != MathKind::kRelation && part.kind != MathKind::kPunctuation &&
             part.kind != MathKind::kSign &&
             (part.kind != MathKind::kOperator || part.text == QStringLiteral("·"));
    };
    while (first != row.parts.begin() && isInside(*std::prev(first))) {
      --first;
      if (!isWide) break;
    }
    const bool isApart = first != row.parts.end() && first->isApart;
    MathNode above{MathKind::kRow, {}, {}};
    std::move(first, row.parts.end(), std::back_inserter(above.parts));
    row.parts.erase(first, row.parts.end());
    MathNode below{MathKind::kRow, {}, {}};
    if (!atEnd() && !kClosing.contains(next())) below.parts.push_back(readPart(row));
    row.parts.push_back({MathKind::kFraction, {}, {std::move(above), std::move(below)}, isApart});
  }

  /// @param row  what stands before it
  MathNode readPart(const MathNode& row) {
    const QChar sign = next();
    if (kOperators.contains(sign) || sign == QChar(u'±')) {
      ++m_place;
      return {needsLeftSide(row) ? MathKind::kSign : MathKind::kOperator, sign, {}};
    }
    if (kRelations.contains(sign)) {
      ++m_place;
      return {MathKind::kRelation, sign, {}};
    }
    if (sign == ',' || sign == ';' || sign == ':') {
      ++m_place;
      return {MathKind::kPunctuation, sign, {}};
    }
    return readScripts(readBase());
  }

  static bool needsLeftSide(const MathNode& row) {
    if (row.parts.empty()) return true;
    const MathKind before = row.parts.back().kind;
    return before == MathKind::kOperator || before == MathKind::kSign ||
           before == MathKind::kRelation || before == MathKind::kPunctuation;
  }

  MathNode readBase() {
    const QChar sign = next();
    if (sign == QChar(u'√')) {
      ++m_place;
      skipSpaces();
      MathNode inside = atEnd() ? MathNode() : readScripts(readBase());
      return {MathKind::kRoot, {}, {std::move(inside)}};
    }
    if (kOpening.contains(sign)) return readFence(kClosing[kOpening.indexOf(sign)]);
    if (sign == '|' && m_text.indexOf('|', m_place + 1) > 0) return readFence('|');
    if (sign.isLetter() && sign != QChar(u'Σ')) return readLetters();
    if (sign.isDigit() && !kRaised.contains(sign) && !kLowered.contains(sign)) return readNumber();
    ++m_place;
    return {MathKind::kUpright, sign, {}};
  }

  MathNode readFence(QChar end) {
    const QString signs = QString(next()) + end;
    ++m_place;
    MathNode inside = readRow(end);
    if (!atEnd()) ++m_place;
    return {MathKind::kFence, signs, {std::move(inside)}};
  }

  bool isLetterAt(qsizetype place) const {
    return place < m_text.size() && m_text[place].isLetter() && m_text[place] != QChar(u'Σ') &&
           !kRaised.contains(m_text[place]) && !kLowered.contains(m_text[place]);
  }

  /// The apostrophe in "l’air".
  bool isElisionAt(qsizetype place) const {
    return place < m_text.size() && m_text[place] == QChar(u'’') && isLetterAt(place + 1);
  }

  MathNode readLetters() {
    const qsizetype first = m_place;
    while (isLetterAt(m_place) || isElisionAt(m_place)) ++m_place;
    const QString letters = m_text.mid(first, m_place - first);
    if (letters.size() == 1) return {MathKind::kVariable, letters, {}};
    return {MathKind::kWord, letters, {}};
  }

  MathNode readNumber() {
    const qsizetype first = m_place;
    const auto isPart = [this](qsizetype place) {
      if (place >= m_text.size() || kRaised.contains(m_text[place])) return false;
      const bool isPoint = m_text[place] == '.' && place + 1 < m_text.size();
      return (isPoint ? m_text[place + 1] : m_text[place]).isDigit() &&
             !kLowered.contains(m_text[place]);
    };
    while (isPart(m_place)) ++m_place;
    return {MathKind::kUpright, m_text.mid(first, m_place - first), {}};
  }

  /// Whatever is lowered or raised on it.
  MathNode readScripts(MathNode base) {
    MathNode below, above;
    QString primes;
    while (!atEnd()) {
      const QChar sign = next();
      if (sign == '_' || sign == '^') {
        ++m_place;
        (sign == '_' ? below : above).parts.push_back(atEnd() ? MathNode() : readBase());
      } else if (sign == '\'') {
        ++m_place;
        primes += QChar(u'′');
      } else if (kRaised.contains(sign)) {
        above.parts.push_back(readSmall(kRaised, kRaisedMeans));
      } else if (kLowered.contains(sign)) {
        below.parts.push_back(readSmall(kLowered, kLoweredMeans));
      } else {
        break;
      }
    }
    if (below.parts.empty() && above.parts.empty() && primes.isEmpty()) return base;
    return {MathKind::kScripts, primes, {std::move(base), std::move(below), std::move(above)}};
  }

  MathNode readSmall(const QString& signs, const QString& meanings) {
    const QChar meaning = meanings[signs.indexOf(m_text[m_place++])];
    return {meaning.isLetter() ? MathKind::kVariable : MathKind::kUpright, meaning, {}};
  }

  QString m_text;
  qsizetype m_place = 0;
};

}  // namespace

MathNode readMath(const QString& text) {
  return Reader(text).readAll();
}

}  // namespace ui
