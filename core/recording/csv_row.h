#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace core {

/// Puts the fields of one CSV row behind each other, and ends the row when it goes out of scope.
/// Numbers are written in the shortest form that reads back; no field may need quotes.
class CsvRow {
 public:
  explicit CsvRow(std::string& csv) : m_csv(csv) {}
  CsvRow(const CsvRow&) = delete;
  CsvRow& operator=(const CsvRow&) = delete;
  ~CsvRow() { m_csv += "\r\n"; }

  CsvRow& operator<<(std::string_view field) {
    if (m_hasFields) m_csv += ',';
    m_hasFields = true;
    m_csv += field;
    return *this;
  }

  template <class Number>
  requires std::is_arithmetic_v<Number> CsvRow& operator<<(Number number) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return *this << std::string_view(text.data(), end);
  }

 private:
  std::string& m_csv;
  bool m_hasFields = false;
};

}  // namespace core
