#include "ui/files/strict_reader.h"

#include <algorithm>
#include <cstdint>

#include <QCoreApplication>

#include "ui/files/degree_text.h"

namespace ui {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::StrictReader)
};

QString describe(JsonKind kind) {
  switch (kind) {
    case JsonKind::kNull:
      return Words::tr("null");
    case JsonKind::kBoolean:
      return Words::tr("true or false");
    case JsonKind::kNumber:
      return Words::tr("a number");
    case JsonKind::kString:
      return Words::tr("a text");
    case JsonKind::kArray:
      return Words::tr("a list");
    case JsonKind::kObject:
      return Words::tr("an object");
  }
  return {};
}

}  // namespace

QString quoted(std::string_view text) {
  constexpr qsizetype kLongest = 40;
  QString shown = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  for (QChar& character : shown) {
    if (!character.isPrint() && !character.isSurrogate()) character = QChar::ReplacementCharacter;
  }
  if (shown.size() > kLongest) shown = shown.left(kLongest) + QChar(0x2026);
  return '"' + shown + '"';
}

void StrictReader::refuse(const QString& reason) const {
  const std::string& place = m_place.empty() ? m_outermost : m_place;
  throw ValueRefused{QString::fromStdString(place) + QStringLiteral(": ") + reason};
}

void StrictReader::expect(JsonKind kind) {
  const JsonKind found = m_json.kind();
  if (found != kind) refuse(Words::tr("must be %1, got %2").arg(describe(kind), describe(found)));
}

std::string_view StrictReader::readDigits() {
  expect(JsonKind::kNumber);
  const std::string_view digits = m_json.readNumber();
  if (!numberFromText(digits)) {
    refuse(Words::tr("%1 is too large or too small to reckon with").arg(ui::quoted(digits)));
  }
  return digits;
}

double StrictReader::readNumber() {
  return *numberFromText(readDigits());
}

std::optional<double> StrictReader::readNumberOrNull() {
  if (m_json.kind() != JsonKind::kNull) return readNumber();
  m_json.readNull();
  return std::nullopt;
}

bool StrictReader::readBoolean() {
  expect(JsonKind::kBoolean);
  return m_json.readBoolean();
}

std::string StrictReader::readString() {
  expect(JsonKind::kString);
  return m_json.readString();
}

void StrictReader::readObject(std::initializer_list<Member> members) {
  expect(JsonKind::kObject);
  std::uint32_t seen = 0;
  m_json.enter();
  while (const std::optional<std::string> key = m_json.nextKey()) {
    const auto member = std::ranges::find(members, *key, &Member::key);
    if (member == members.end()) refuse(Words::tr("unknown key %1").arg(ui::quoted(*key)));
    const PlaceScope place(m_place, *key);
    const std::uint32_t bit = 1U << (member - members.begin());
    if (seen & bit) refuse(Words::tr("stands twice"));
    seen |= bit;
    member->read();
  }
}

void StrictReader::readList(int fewest, int most, const std::function<void()>& readEntry) {
  expect(JsonKind::kArray);
  int count = 0;
  m_json.enter();
  for (; m_json.nextElement(); ++count) {
    if (count < most) {
      const PlaceScope place(m_place, count);
      readEntry();
    } else {
      m_json.skipValue();  // to say how many there are
    }
  }
  if (count >= fewest && count <= most) return;
  refuse(fewest == most
             ? Words::tr("must have %1 entries, got %2").arg(most).arg(count)
             : Words::tr("must have %1 to %2 entries, got %3").arg(fewest).arg(most).arg(count));
}

}  // namespace ui
