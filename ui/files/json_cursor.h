#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <QCoreApplication>
#include <QString>

namespace ui {

/// What kind of value stands at a place in JSON text.
enum class JsonKind { kNull, kBoolean, kNumber, kString, kArray, kObject };

/// Thrown by JsonCursor: "line 3, column 7: a comma or } must stand here".
struct JsonError {
  QString line;
};

/// Walks through JSON text (RFC 8259, strictly) value by value.
///
/// Keeps what QJsonDocument forgets: keys that stand twice, their order, and the digits of
/// numbers. Nothing is stored, so a file of any size costs no memory beyond its text.
/// Every function throws JsonError where the text is not JSON.
class JsonCursor {
  Q_DECLARE_TR_FUNCTIONS(ui::JsonCursor)

 public:
  /// @param text  valid UTF-8, must outlive the cursor; a byte order mark is passed over
  explicit JsonCursor(std::string_view text);

  /// Of the value that comes next.
  JsonKind kind();

  // Pass the next value; @pre it is of that kind.
  void readNull();
  bool readBoolean();
  std::string_view readNumber();  ///< its characters
  std::string readString();       ///< UTF-8, escapes resolved

  void skipValue();

  /// Goes into the array or object that comes next; then ask nextElement() or nextKey()
  /// before each value until there is none.
  void enter();
  bool nextElement();
  std::optional<std::string> nextKey();

  /// How much of the text is passed [bytes].
  std::size_t position() const { return m_at; }

  /// Checks that nothing but white space is left.
  void expectEnd();

 private:
  [[noreturn]] void fail(const QString& reason) const;
  void skipSpace();
  bool take(char wanted);
  bool takeWord(std::string_view word);
  void takeDigits();
  bool startsNext(char end);
  char nextCharacter();
  void appendEscaped(std::string& text);
  char32_t readCodePoint();
  char16_t readHexUnit();

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_depth = 0;
  bool m_justEntered = false;
};

}  // namespace ui
