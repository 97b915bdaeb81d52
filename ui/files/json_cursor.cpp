#include "ui/files/json_cursor.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <QChar>

namespace ui {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr int kDeepest = 64;

bool isDigit(char c) {
  return '0' <= c && c <= '9';
}

/// Characters, not bytes: what an editor shows as the column.
qsizetype characterCount(std::string_view utf8) {
  return std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; });
}

}  // namespace

JsonCursor::JsonCursor(std::string_view text) : m_text(text) {
  if (m_text.starts_with(kByteOrderMark)) m_at = kByteOrderMark.size();
}

void JsonCursor::fail(const QString& reason) const {
  const std::string_view before = m_text.substr(0, std::min(m_at, m_text.size()));
  const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
  throw JsonError{tr("line %1, column %2: %3")
                      .arg(std::ranges::count(before, '\n') + 1)
                      .arg(characterCount(before.substr(lineStart)) + 1)
                      .arg(reason)};
}

void JsonCursor::skipSpace() {
  m_at = std::min(m_text.find_first_not_of(" \t\r\n", m_at), m_text.size());
}

bool JsonCursor::take(char wanted) {
  if (m_at == m_text.size() || m_text[m_at] != wanted) return false;
  ++m_at;
  return true;
}

bool JsonCursor::takeWord(std::string_view word) {
  if (!m_text.substr(m_at).starts_with(word)) return false;
  m_at += word.size();
  return true;
}

JsonKind JsonCursor::kind() {
  skipSpace();
  if (m_at == m_text.size()) fail(tr("the text ends where a value must stand"));
  switch (m_text[m_at]) {
    case 'n':
      return JsonKind::kNull;
    case 't':
    case 'f':
      return JsonKind::kBoolean;
    case '"':
      return JsonKind::kString;
    case '[':
      return JsonKind::kArray;
    case '{':
      return JsonKind::kObject;
    default:
      break;
  }
  if (m_text[m_at] != '-' && !isDigit(m_text[m_at])) fail(tr("a value must stand here"));
  return JsonKind::kNumber;
}

void JsonCursor::readNull() {
  if (!takeWord("null")) fail(tr("a value must stand here"));
}

bool JsonCursor::readBoolean() {
  if (takeWord("true")) return true;
  if (!takeWord("false")) fail(tr("a value must stand here"));
  return false;
}

void JsonCursor::takeDigits() {
  if (m_at == m_text.size() || !isDigit(m_text[m_at])) fail(tr("a digit must stand here"));
  while (m_at < m_text.size() && isDigit(m_text[m_at])) ++m_at;
}

std::string_view JsonCursor::readNumber() {
  const std::size_t start = m_at;
  take('-');
  if (!take('0')) takeDigits();
  if (take('.')) takeDigits();
  if (take('e') || take('E')) {
    if (!take('+')) take('-');
    takeDigits();
  }
  return m_text.substr(start, m_at - start);
}

char JsonCursor::nextCharacter() {
  if (m_at == m_text.size()) fail(tr("the text ends inside a string"));
  return m_text[m_at++];
}

std::string JsonCursor::readString() {
  std::string text;
  take('"');
  for (char c = nextCharacter(); c != '"'; c = nextCharacter()) {
    if (static_cast<unsigned char>(c) < 0x20) {
      --m_at;
      fail(tr("a control character must be written as an escape"));
    }
    if (c == '\\') {
      appendEscaped(text);
    } else {
      text += c;
    }
  }
  return text;
}

void JsonCursor::appendEscaped(std::string& text) {
  constexpr std::string_view kLetters = "\"\\/bfnrt";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  const char letter = nextCharacter();
  if (letter == 'u') {
    const char32_t codePoint = readCodePoint();
    text += QString::fromUcs4(&codePoint, 1).toStdString();
    return;
  }
  const std::size_t index = kLetters.find(letter);
  if (index == std::string_view::npos) {
    --m_at;
    fail(tr("unknown escape in a string"));
  }
  text += kMeanings[index];
}

char32_t JsonCursor::readCodePoint() {
  const char16_t first = readHexUnit();
  if (!QChar::isSurrogate(first)) return first;
  if (QChar::isHighSurrogate(first) && takeWord("\\u")) {
    const char16_t second = readHexUnit();
    if (QChar::isLowSurrogate(second)) return QChar::surrogateToUcs4(first, second);
  }
  fail(tr("half a surrogate pair in a string"));
}

char16_t JsonCursor::readHexUnit() {
  unsigned value = 0;
  const std::string_view digits = m_text.substr(m_at, 4);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (end != digits.data() + 4) fail(tr("four hexadecimal digits must stand here"));
  m_at += 4;
  return static_cast<char16_t>(value);
}

void JsonCursor::enter() {
  if (++m_depth > kDeepest) fail(tr("nested too deeply"));
  ++m_at;
  m_justEntered = true;
}

bool JsonCursor::startsNext(char end) {
  const bool isFirst = std::exchange(m_justEntered, false);
  skipSpace();
  if (take(end)) {
    --m_depth;
    return false;
  }
  if (!isFirst && !take(',')) fail(tr("a comma or %1 must stand here").arg(QLatin1Char(end)));
  return true;
}

bool JsonCursor::nextElement() {
  return startsNext(']');
}

std::optional<std::string> JsonCursor::nextKey() {
  if (!startsNext('}')) return std::nullopt;
  skipSpace();
  if (m_at == m_text.size() || m_text[m_at] != '"') fail(tr("a key in quotes must stand here"));
  std::string key = readString();
  skipSpace();
  if (!take(':')) fail(tr("a colon must stand here"));
  return key;
}

void JsonCursor::skipValue() {
  switch (kind()) {
    case JsonKind::kNull:
      return readNull();
    case JsonKind::kBoolean:
      readBoolean();
      return;
    case JsonKind::kNumber:
      readNumber();
      return;
    case JsonKind::kString:
      readString();
      return;
    case JsonKind::kArray:
      enter();
      while (nextElement()) skipValue();
      return;
    case JsonKind::kObject:
      enter();
      while (nextKey()) skipValue();
      return;
  }
}

void JsonCursor::expectEnd() {
  skipSpace();
  if (m_at != m_text.size()) fail(tr("nothing more may stand here"));
}

}  // namespace ui
