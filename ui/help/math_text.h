#pragma once

#include <vector>

#include <QString>

namespace ui {

/// What a part of an equation is.
enum class MathKind {
  kRow,          ///< parts side by side
  kVariable,     ///< one letter, set in italics
  kUpright,      ///< a number or another sign
  kWord,         ///< a word, or the name of a function
  kOperator,     ///< between two parts: +, −, ·
  kSign,         ///< before a part: −, ±
  kRelation,     ///< =, ≥, →
  kPunctuation,  ///< followed by a space
  kFraction,     ///< of parts 0 and 1
  kRoot,         ///< of part 0
  kScripts,      ///< on part 0: below it part 1, above it part 2, either of them an empty row;
                 ///< the text: primes
  kFence,        ///< part 0 between the two signs of the text
};

/// An equation or a part of it.
struct MathNode {
  MathKind kind = MathKind::kRow;
  QString text;
  std::vector<MathNode> parts;
  bool isApart = false;  ///< a space stands before it
};

/// Reads an equation as core/model.md writes them, so that they are read there with ease, too:
/// a_b and a_(b c) for indices, a², a^n and a' for what is raised, √a and √(a b) for roots. A
/// slash with spaces around it divides all before it, back to the last sum or relation, by what
/// comes next; one without divides its neighbours. Words of two letters and more are words.
///
/// Whatever the text is, every sign of it is in the result.
MathNode readMath(const QString& text);

}  // namespace ui
