#include "ui/style/event_mark.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include "ui/style/theme.h"

using core::EventKind;

namespace {

constexpr EventKind kKinds[] = {
    EventKind::kCut,        EventKind::kTurningPoint, EventKind::kSlack,
    EventKind::kTaut,       EventKind::kImpactFloor,  EventKind::kImpactCeiling,
    EventKind::kImpactWest, EventKind::kImpactEast,   EventKind::kImpactWeight,
    EventKind::kRest,
};
constexpr int kSize = 24;

QImage drawn(EventKind kind, const ui::Theme& theme) {
  QImage image(kSize, kSize, QImage::Format_RGB32);
  image.fill(theme.background);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  ui::drawEventMark(painter, kind, {kSize / 2.0, kSize / 2.0}, kSize, theme);
  return image;
}

/// All signs in one color, so that only their shapes tell them apart.
ui::Theme inOneColor() {
  ui::Theme theme = ui::Theme::light();
  theme.drift = theme.potential = theme.lostToRopes = theme.lostToImpacts = theme.kinetic =
      theme.lostToFriction = theme.text;
  return theme;
}

int differingPixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) count += a.pixel(x, y) != b.pixel(x, y);
  }
  return count;
}

}  // namespace

class EventMarkTest : public QObject {
  Q_OBJECT

 private slots:
  void kindsDifferInShapeAlone();
  void staysWithinItsSize();
};

void EventMarkTest::kindsDifferInShapeAlone() {
  const ui::Theme theme = inOneColor();
  QImage blank(kSize, kSize, QImage::Format_RGB32);
  blank.fill(theme.background);
  for (const EventKind a : kKinds) {
    QVERIFY(differingPixels(drawn(a, theme), blank) > kSize * kSize / 10);
    for (const EventKind b : kKinds) {
      if (a == b) continue;
      QVERIFY2(differingPixels(drawn(a, theme), drawn(b, theme)) > kSize * kSize / 10,
               qPrintable(QString("%1 and %2").arg(int(a)).arg(int(b))));
    }
  }
}

void EventMarkTest::staysWithinItsSize() {
  const ui::Theme theme = ui::Theme::light();
  for (const EventKind kind : kKinds) {
    QImage image(2 * kSize, 2 * kSize, QImage::Format_RGB32);
    image.fill(theme.background);
    QPainter painter(&image);
    ui::drawEventMark(painter, kind, {kSize, kSize}, kSize, theme);
    painter.end();
    for (int i = 0; i < 2 * kSize; ++i) {
      for (const int edge : {kSize / 2 - 2, 3 * kSize / 2 + 1}) {
        QCOMPARE(image.pixelColor(i, edge), theme.background);
        QCOMPARE(image.pixelColor(edge, i), theme.background);
      }
    }
  }
}

QTEST_GUILESS_MAIN(EventMarkTest)
#include "event_mark_test.moc"
