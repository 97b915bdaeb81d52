#include "ui/help/math_text.h"

#include <QRegularExpression>
#include <QTest>

#include "ui/files/long_text.h"

using ui::MathKind;
using ui::MathNode;

namespace {

/// The tree in brackets, each kind of part with a sign of its own.
QString written(const MathNode& node) {
  QStringList parts;
  for (const MathNode& part : node.parts) parts << written(part);
  switch (node.kind) {
    case MathKind::kRow:
      return parts.join(' ');
    case MathKind::kFraction:
      return "frac{" + parts.join("}{") + '}';
    case MathKind::kRoot:
      return "root{" + parts[0] + '}';
    case MathKind::kScripts:
      return parts[0] + node.text + "_{" + parts[1] + "}^{" + parts[2] + '}';
    case MathKind::kFence:
      return node.text[0] + parts[0] + node.text[1];
    case MathKind::kVariable:
      return '*' + node.text;
    case MathKind::kSign:
      return "sign" + node.text;
    default:
      return node.text;
  }
}

/// All signs of a text but spaces and those that are notation.
QString signsOf(QString text) {
  return text.remove(QRegularExpression(QStringLiteral("[\\s_^()/√|\\[\\]′']")));
}

QString signsOf(const MathNode& node) {
  QString signs =
      node.kind == MathKind::kScripts || node.kind == MathKind::kFence ? QString() : node.text;
  for (const MathNode& part : node.parts) signs += signsOf(part);
  return signsOf(signs);
}

}  // namespace

class MathTextTest : public QObject {
  Q_OBJECT

 private slots:
  void reads_data();
  void reads();
  void losesNothingOfTheModel_data();
  void losesNothingOfTheModel();
  void readsAnything_data();
  void readsAnything();
};

void MathTextTest::reads_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("tree");
  QTest::newRow("product") << "m g y"
                           << "*m *g *y";
  QTest::newRow("prime") << "θ' = ω"
                         << "*θ′_{}^{} = *ω";
  QTest::newRow("index") << "c_d"
                         << "*c_{*d}^{}";
  QTest::newRow("index and power") << "v_r²"
                                   << "*v_{*r}^{2}";
  QTest::newRow("index of several") << "b_(i+1)"
                                    << "*b_{(*i + 1)}^{}";
  QTest::newRow("powers") << "10⁻¹²"
                          << "10_{}^{− 1 2}";
  QTest::newRow("caret") << "u^i"
                         << "*u_{}^{*i}";
  QTest::newRow("small index") << "v₀ₙ"
                               << "*v_{0 *n}^{}";
  QTest::newRow("neighbours divided") << "−(g/L) sin θ"
                                      << "sign− (frac{*g}{*L}) sin *θ";
  QTest::newRow("all before divided") << "κ = ρ A / (2 m)"
                                      << "*κ = frac{*ρ *A}{(2 *m)}";
  QTest::newRow("up to the sum") << "a + b c / d"
                                 << "*a + frac{*b *c}{*d}";
  QTest::newRow("root") << "√(g/q)"
                        << "root{(frac{*g}{*q})}";
  QTest::newRow("root with index") << "√w_0"
                                   << "root{*w_{0}^{}}";
  QTest::newRow("absolute") << "|ω| ω"
                            << "|*ω| *ω";
  QTest::newRow("sign or difference") << "−a − b = −c"
                                      << "sign− *a − *b = sign− *c";
  QTest::newRow("words") << "lost to air"
                         << "lost to air";
  QTest::newRow("word with an apostrophe") << "dans l’air"
                                           << "dans l’air";
  QTest::newRow("functions") << "cos θ"
                             << "cos *θ";
}

void MathTextTest::reads() {
  QFETCH(QString, text);
  QFETCH(QString, tree);
  QCOMPARE(written(ui::readMath(text)), tree);
}

void MathTextTest::losesNothingOfTheModel_data() {
  QTest::addColumn<QString>("language");
  for (const QString& language : ui::languagesOf("help"))
    QTest::newRow(qPrintable(language)) << language;
}

void MathTextTest::losesNothingOfTheModel() {
  QFETCH(QString, language);
  int equations = 0;
  for (const QString& line : ui::longText("help", "model", language).split('\n')) {
    if (!line.startsWith(QStringLiteral("    "))) continue;
    ++equations;
    QString expected = signsOf(line);
    for (const auto& [small, usual] : {std::pair{u'²', u'2'}, {u'³', u'3'}, {u'⁴', u'4'}})
      expected.replace(small, QChar(usual));
    // Indices are told before powers, whatever the order they are written in.
    QString found = signsOf(ui::readMath(line));
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    QCOMPARE(found, expected);
  }
  QVERIFY(equations > 20);
}

void MathTextTest::readsAnything_data() {
  QTest::addColumn<QString>("text");
  for (const char* text : {"",  "(", ")",    "a)", "((a",   "|a", "a/", "/",  "/a", "a_",  "_",
                           "^", "√", "a_^'", "−",  "a | b", "∂",  "½",  "1.", ".",  "a__b"})
    QTest::newRow(*text ? text : "nothing") << QString::fromUtf8(text);
}

void MathTextTest::readsAnything() {
  QFETCH(QString, text);
  QVERIFY(signsOf(ui::readMath(text)).size() >= signsOf(text).size());
}

QTEST_GUILESS_MAIN(MathTextTest)
#include "math_text_test.moc"
