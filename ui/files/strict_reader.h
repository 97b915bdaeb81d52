#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <QString>
#include <QtGlobal>

#include "ui/files/json_cursor.h"

namespace ui {

/// Thrown by StrictReader: "weights[3].rope.length: must be a number, got a text".
struct ValueRefused {
  QString line;
};

/// Text from a file in quotes, fit to stand in a message of one line.
QString quoted(std::string_view text);

/// Names a value's place while it is read: "weights", then "weights[3]" inside.
class PlaceScope {
 public:
  PlaceScope(std::string& place, std::string_view key) : PlaceScope(place) {
    if (!m_place.empty()) m_place += '.';
    m_place += key;
  }
  PlaceScope(std::string& place, int index) : PlaceScope(place) {
    m_place += '[' + std::to_string(index) + ']';
  }
  ~PlaceScope() { m_place.resize(m_outerLength); }
  Q_DISABLE_COPY_MOVE(PlaceScope)

 private:
  explicit PlaceScope(std::string& place) : m_place(place), m_outerLength(place.size()) {}

  std::string& m_place;
  std::size_t m_outerLength;
};

/// What readers of one format have in common: reads the values of a JSON text and knows the
/// place of each. A value of the wrong type, an unknown key or a key that stands twice is
/// refused. Every function throws ValueRefused, or JsonError where the text is not JSON.
class StrictReader {
 protected:
  /// @param text       valid UTF-8, must outlive the reader
  /// @param outermost  what messages call the whole text's value
  StrictReader(std::string_view text, std::string outermost)
      : m_json(text), m_outermost(std::move(outermost)) {}

  struct Member {
    std::string_view key;
    std::function<void()> read;
  };

  /// Reads an object that has none but these keys.
  void readObject(std::initializer_list<Member> members);
  /// Calls `readEntry` for the entries of a list; refuses it unless it has so many.
  void readList(int fewest, int most, const std::function<void()>& readEntry);
  double readNumber();
  std::optional<double> readNumberOrNull();
  /// The characters of a number that a double can hold.
  std::string_view readDigits();
  bool readBoolean();
  std::string readString();

  void expect(JsonKind kind);
  [[noreturn]] void refuse(const QString& reason) const;

  JsonCursor m_json;
  std::string m_place;  // of the value being read, such as "weights[3].rope"

 private:
  std::string m_outermost;
};

}  // namespace ui
