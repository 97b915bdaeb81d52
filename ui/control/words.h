#pragma once

#include <functional>
#include <type_traits>
#include <utility>

#include <QString>

namespace ui {

/// Words that outlive a change of the language: they are made anew whenever they are read.
class Words {
 public:
  Words() = default;
  // Implicit, so that texts and what makes them can stand wherever words are wanted.
  // NOLINTBEGIN(google-explicit-constructor)

  /// Words that are the same in every language, such as names.
  Words(QString text) : m_make([text = std::move(text)] { return text; }) {}
  Words(const char* text) : Words(QString::fromUtf8(text)) {}
  /// @param make  gives them in the language in force, as `[] { return tr("…"); }` does; called
  ///              as long as the words live
  template <class Make>
  requires std::is_invocable_r_v<QString, Make> Words(Make make) : m_make(std::move(make)) {}
  // NOLINTEND(google-explicit-constructor)

  /// In the language in force.
  QString text() const { return m_make ? m_make() : QString(); }

 private:
  std::function<QString()> m_make;
};

}  // namespace ui
