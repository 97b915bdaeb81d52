#include "ui/files/json_cursor.h"

#include <string>

#include <QtTest>

using ui::JsonCursor;
using ui::JsonError;
using ui::JsonKind;

namespace {

/// The error met on the way through the whole text; empty if there is none.
QString errorIn(std::string_view text) {
  try {
    JsonCursor json(text);
    json.skipValue();
    json.expectEnd();
  } catch (const JsonError& error) {
    return error.line;
  }
  return {};
}

std::string stringIn(std::string_view text) {
  JsonCursor json(text);
  return json.kind() == JsonKind::kString ? json.readString() : "no string";
}

}  // namespace

class JsonCursorTest : public QObject {
  Q_OBJECT

 private slots:
  void acceptsEveryKindOfValue_data();
  void acceptsEveryKindOfValue();
  void namesLineAndColumnOfAFault_data();
  void namesLineAndColumnOfAFault();
  void resolvesEscapes_data();
  void resolvesEscapes();
  void keepsTheDigitsOfNumbers();
  void givesKeysInTheirOrderAndTwiceWhereTheyStandTwice();
  void refusesEndlessNestingWithoutExhaustingTheStack();
};

void JsonCursorTest::acceptsEveryKindOfValue_data() {
  QTest::addColumn<QByteArray>("text");
  for (const char* text : {"null",         "true",
                           "false",        "0",
                           "-0",           "-0.5",
                           "1e9",          "1E+9",
                           "2.5e-3",       "\"\"",
                           "\"a\"",        "[]",
                           "[ ]",          "[1]",
                           "[1, [2], {}]", "{}",
                           "{ }",          "{\"a\": 1, \"b\": [true]}",
                           " \t\r\n 1 \n", "\xEF\xBB\xBF{}"}) {
    QTest::newRow(text) << QByteArray(text);
  }
}

void JsonCursorTest::acceptsEveryKindOfValue() {
  QFETCH(QByteArray, text);
  QCOMPARE(errorIn(text.toStdString()), QString());
}

void JsonCursorTest::namesLineAndColumnOfAFault_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("error");
  const auto row = [](const char* name, const QByteArray& text, const char* error) {
    QTest::newRow(name) << text << QString(error);
  };
  row("nothing", "", "line 1, column 1: the text ends where a value must stand");
  row("a word", "[nan]", "line 1, column 2: a value must stand here");
  row("NaN", "[NaN]", "line 1, column 2: a value must stand here");
  row("Infinity", "-Infinity", "line 1, column 2: a digit must stand here");
  row("half a word", "tru", "line 1, column 1: a value must stand here");
  row("plus sign", "+1", "line 1, column 1: a value must stand here");
  row("leading zero", "[01]", "line 1, column 3: a comma or ] must stand here");
  row("no digit behind the point", "1.", "line 1, column 3: a digit must stand here");
  row("no digit before the point", ".5", "line 1, column 1: a value must stand here");
  row("no exponent", "1e", "line 1, column 3: a digit must stand here");
  row("comma at the end of a list", "[1,]", "line 1, column 4: a value must stand here");
  row("comma at the end of an object", "{\"a\":1,}",
      "line 1, column 8: a key in quotes must stand here");
  row("no comma", "[1 2]", "line 1, column 4: a comma or ] must stand here");
  row("no colon", "{\"a\" 1}", "line 1, column 6: a colon must stand here");
  row("key without quotes", "{a: 1}", "line 1, column 2: a key in quotes must stand here");
  row("list left open", "[1", "line 1, column 3: a comma or ] must stand here");
  row("object left open", "{", "line 1, column 2: a key in quotes must stand here");
  row("string left open", "\"abc", "line 1, column 5: the text ends inside a string");
  row("wrong bracket", "[1}", "line 1, column 3: a comma or ] must stand here");
  row("more behind the end", "{} {}", "line 1, column 4: nothing more may stand here");
  row("comment", "{} // note", "line 1, column 4: nothing more may stand here");
  row("unknown escape", "\"\\q\"", "line 1, column 3: unknown escape in a string");
  row("short escape", "\"\\u12\"", "line 1, column 4: four hexadecimal digits must stand here");
  row("half a pair", "\"\\ud800\"", "line 1, column 8: half a surrogate pair in a string");
  row("line break in a string", "\"a\nb\"",
      "line 1, column 3: a control character must be written as an escape");
  row("null byte", QByteArray("\"a\0b\"", 5),
      "line 1, column 3: a control character must be written as an escape");
  row("in line three", "{\n  \"a\": 1,\n  b\n}",
      "line 3, column 3: a key in quotes must stand here");
  row("columns count characters", "[\"åäö\" 1]", "line 1, column 8: a comma or ] must stand here");
}

void JsonCursorTest::namesLineAndColumnOfAFault() {
  QFETCH(QByteArray, text);
  QFETCH(QString, error);
  QCOMPARE(errorIn(text.toStdString()), error);
}

void JsonCursorTest::resolvesEscapes_data() {
  QTest::addColumn<QByteArray>("json");
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("plain") << QByteArray("\"Galgen – 7\"") << QByteArray("Galgen – 7");
  QTest::newRow("letters") << QByteArray(R"("\"\\\/\b\f\n\r\t")") << QByteArray("\"\\/\b\f\n\r\t");
  QTest::newRow("two bytes") << QByteArray(R"("\u00e5\u00C5")") << QByteArray("åÅ");
  QTest::newRow("three bytes") << QByteArray(R"("\u2260")") << QByteArray("≠");
  QTest::newRow("surrogate pair") << QByteArray(R"("\ud83c\udfaf")") << QByteArray("🎯");
}

void JsonCursorTest::resolvesEscapes() {
  QFETCH(QByteArray, json);
  QFETCH(QByteArray, text);
  QCOMPARE(QByteArray::fromStdString(stringIn(json.toStdString())), text);
}

void JsonCursorTest::keepsTheDigitsOfNumbers() {
  const std::string text = "-0.10000000000000000000000001e+02 ";
  JsonCursor json(text);
  QCOMPARE(json.kind(), JsonKind::kNumber);
  QCOMPARE(json.readNumber(), std::string_view("-0.10000000000000000000000001e+02"));
}

void JsonCursorTest::givesKeysInTheirOrderAndTwiceWhereTheyStandTwice() {
  const std::string text = R"({"b": 1, "a": [2], "b": {}})";
  JsonCursor json(text);
  std::string keys;
  json.enter();
  while (const std::optional<std::string> key = json.nextKey()) {
    keys += *key;
    json.skipValue();
  }
  QCOMPARE(keys, std::string("bab"));
}

void JsonCursorTest::refusesEndlessNestingWithoutExhaustingTheStack() {
  const std::string text(1'000'000, '[');
  QCOMPARE(errorIn(text), QString("line 1, column 65: nested too deeply"));
}

QTEST_GUILESS_MAIN(JsonCursorTest)
#include "json_cursor_test.moc"
