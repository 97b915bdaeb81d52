#include "ui/help/math_picture.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

#include "ui/help/inline_drawing.h"
#include "ui/help/math_text.h"

using ui::MathPicture;
using ui::MathStyle;

namespace {

QFont letters() {
  QFont font;
  font.setPointSizeF(20);
  return font;
}

MathPicture set(const char* text, MathStyle style = MathStyle::kDisplay) {
  return ui::mathPicture(ui::readMath(QString::fromUtf8(text)), style, letters(), nullptr);
}

const MathPicture::Words& wordsOf(const MathPicture& picture, const char* text) {
  const auto found =
      std::ranges::find(picture.words, QString::fromUtf8(text), &MathPicture::Words::text);
  if (found == picture.words.end()) qFatal("not in the picture: %s", text);
  return *found;
}

}  // namespace

class MathPictureTest : public QObject {
  Q_OBJECT

 private slots:
  void slantsVariablesAlone();
  void setsFractionsOneAboveTheOther();
  void setsFractionsWithASlashInALine();
  void lowersIndicesAndRaisesPowers();
  void putsARootOverWhatItCovers();
  void stretchesBrackets();
  void alignsLinesAtTheirRelations();
  void drawsWithinItsSize_data();
  void drawsWithinItsSize();
  void shrinksDisplayedLinesToTheirRoom();
};

void MathPictureTest::slantsVariablesAlone() {
  const MathPicture picture = set("m sin θ = 2");
  QVERIFY(wordsOf(picture, "m").font.italic() && wordsOf(picture, "θ").font.italic());
  QVERIFY(!wordsOf(picture, "sin").font.italic() && !wordsOf(picture, "2").font.italic());
}

void MathPictureTest::setsFractionsOneAboveTheOther() {
  const MathPicture picture = set("a / (b c)");
  QCOMPARE(picture.rules.size(), std::size_t{1});
  const QLineF bar = picture.rules[0].line;
  QVERIFY(wordsOf(picture, "a").place.y() < bar.y1());
  QVERIFY(wordsOf(picture, "b").place.y() > bar.y1());
  // Right in the middle, and without the brackets that only kept it together.
  const double middle = wordsOf(picture, "a").place.x() +
                        QFontMetricsF(wordsOf(picture, "a").font).horizontalAdvance("a") / 2;
  QVERIFY(std::abs(middle - bar.center().x()) < bar.length() / 8);
  QCOMPARE(picture.words.size(), std::size_t{3});
}

void MathPictureTest::setsFractionsWithASlashInALine() {
  const MathPicture picture = set("a / (b c)", MathStyle::kInLine);
  QVERIFY(picture.rules.empty());
  QCOMPARE(wordsOf(picture, "/").place.y(), 0.0);
  QCOMPARE(wordsOf(picture, "(").place.y(), 0.0);
}

void MathPictureTest::lowersIndicesAndRaisesPowers() {
  const MathPicture picture = set("v_x²");
  QVERIFY(wordsOf(picture, "x").place.y() > 0);
  QVERIFY(wordsOf(picture, "2").place.y() < 0);
  QCOMPARE(wordsOf(picture, "x").place.x(), wordsOf(picture, "2").place.x());
  QVERIFY(wordsOf(picture, "2").font.pointSizeF() < letters().pointSizeF());
}

void MathPictureTest::putsARootOverWhatItCovers() {
  const MathPicture picture = set("√(g q)");
  const QLineF over = picture.rules.back().line;
  QVERIFY(over.y1() < -set("q").ascent && over.x1() <= wordsOf(picture, "g").place.x());
  QVERIFY(over.x2() >= wordsOf(picture, "q").place.x() + set("q").width);
}

void MathPictureTest::stretchesBrackets() {
  QVERIFY(set("(a)").shapes.empty());
  const MathPicture tall = set("(a/b)");
  QCOMPARE(tall.shapes.size(), std::size_t{2});
  const QRectF bracket = tall.shapes[0].boundingRect();
  const MathPicture inside = set("a/b");
  QVERIFY(bracket.top() <= -inside.ascent + 1 && bracket.bottom() >= inside.descent - 1);
}

void MathPictureTest::alignsLinesAtTheirRelations() {
  const MathPicture lines =
      ui::mathLines({QStringLiteral("    a b c = d"), QStringLiteral("    e = f        words")},
                    letters(), nullptr);
  std::vector<double> relations;
  for (const MathPicture::Words& words : lines.words)
    if (words.text == QStringLiteral("=")) relations.push_back(words.place.x());
  QCOMPARE(relations.size(), std::size_t{2});
  QCOMPARE(relations[0], relations[1]);
  QVERIFY(wordsOf(lines, "f").place.y() > wordsOf(lines, "d").place.y() + letters().pointSizeF());
  QVERIFY(wordsOf(lines, "words").place.x() > wordsOf(lines, "f").place.x() + 20);
}

void MathPictureTest::drawsWithinItsSize_data() {
  QTest::addColumn<QString>("text");
  for (const char* text : {"θ' = ω", "−(g/L) sin θ", "ρ c_d A L / (2 m)", "√(g/q)", "v_t'²",
                           "u^i (1 − u)^(n−i)", "((a / b) + c) / d", "|ω|³"})
    QTest::newRow(text) << QString::fromUtf8(text);
}

void MathPictureTest::drawsWithinItsSize() {
  QFETCH(QString, text);
  const MathPicture picture =
      ui::mathPicture(ui::readMath(text), MathStyle::kDisplay, letters(), nullptr);
  constexpr int kMargin = 40;
  QImage paper(static_cast<int>(picture.width) + 2 * kMargin,
               static_cast<int>(picture.ascent + picture.descent) + 2 * kMargin,
               QImage::Format_RGB32);
  paper.fill(Qt::white);
  QPainter painter(&paper);
  painter.setPen(Qt::black);
  picture.draw(painter, QPointF(kMargin, kMargin + picture.ascent));
  painter.end();
  QRect ink;
  for (int y = 0; y < paper.height(); ++y)
    for (int x = 0; x < paper.width(); ++x)
      if (qGray(paper.pixel(x, y)) < 128) ink |= QRect(x, y, 1, 1);
  QVERIFY(!ink.isEmpty());
  constexpr int kHair = 3;  // px: letters are drawn on whole ones
  const QRect room(kMargin, kMargin, paper.width() - 2 * kMargin, paper.height() - 2 * kMargin);
  QVERIFY2(room.adjusted(-kHair, -kHair, kHair, kHair).contains(ink), qPrintable(text));
  // And fills it: nothing keeps room for what is not drawn.
  QVERIFY(ink.width() > room.width() * 0.8 - kHair && ink.height() > room.height() * 0.6);
}

void MathPictureTest::shrinksDisplayedLinesToTheirRoom() {
  const auto lines =
      ui::displayedMath({"1/M = n · (velocity from unit impulse along n)    1/M = 1/m",
                         "J = (1 + e) ((v_a − v_b)·n) / (1/M_a + 1/M_b)"});
  const double free = lines->size({letters(), Qt::black}).width();
  for (int percent = 50; percent < 100; ++percent) {
    const double room = free * percent / 100;
    const double width = lines->size({letters(), Qt::black, nullptr, room}).width();
    QVERIFY2(0.85 * room < width && width <= room,
             qPrintable(QStringLiteral("%1 in %2").arg(width).arg(room)));
  }
}

QTEST_MAIN(MathPictureTest)
#include "math_picture_test.moc"
