#include "ui/chart/chart_heading.h"

#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QTest>

using ui::ChartHeading;
using ui::HeadingContent;
using ui::HeadingEntry;

namespace {

constexpr int kRow = 27;  // [px] for type of 20 px
const QColor kMark(0, 0, 255);

HeadingEntry entry(const QString& text, const QString& figures = QString()) {
  HeadingEntry made;
  made.line = QPen(Qt::black, 2);
  made.text = text;
  made.figures = figures;
  if (!figures.isEmpty()) made.mark = kMark;
  return made;
}

HeadingContent twoRuns() {
  HeadingContent content;
  content.legend = {entry("Kinetic"), entry("Potential"), entry("Total")};
  content.runs = {entry("RK4", "drift +0.1 J"), entry("Euler, 1/60 s", "drift +0.2 J")};
  return content;
}

ui::ChartLook look() {
  ui::ChartLook made;
  made.font.setPixelSize(20);
  return made;
}

QImage painted(ChartHeading& heading) {
  QGraphicsScene scene;
  scene.addItem(&heading);
  QImage image(heading.boundingRect().size().toSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  scene.render(&painter, image.rect(), heading.boundingRect());
  painter.end();
  scene.removeItem(&heading);
  return image;
}

/// Rows in which a run's mark stands, from top to bottom.
int rowsWithMarks(const QImage& image) {
  int rows = 0;
  bool before = false;
  for (int y = 0; y < image.height(); ++y) {
    bool found = false;
    for (int x = 0; x < image.width(); ++x) found |= image.pixelColor(x, y) == kMark;
    if (found && !before) ++rows;
    before = found;
  }
  return rows;
}

}  // namespace

class ChartHeadingTest : public QObject {
  Q_OBJECT

 private slots:
  void takesAsManyRowsAsItsWidthNeeds_data();
  void takesAsManyRowsAsItsWidthNeeds();
  void keepsRunsApartFromALegendOfSeveralRows();
  void takesOneRowPerRunWhereRoomIsScarce();
  void takesNoRoomWhenEmpty();
  void keepsItsPlacesWhenFiguresChange();
  void putsTitleNoteAndWarningInRowsOfTheirOwn();
};

void ChartHeadingTest::takesAsManyRowsAsItsWidthNeeds_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("rows");
  QTest::addColumn<int>("rowsWithRuns");

  QTest::newRow("everything side by side") << 1400 << 1 << 1;
  QTest::newRow("runs below the legend") << 800 << 2 << 1;
  QTest::newRow("each run in a row") << 480 << 3 << 2;
  QTest::newRow("figures below the runs") << 250 << 6 << 2;
}

void ChartHeadingTest::takesAsManyRowsAsItsWidthNeeds() {
  QFETCH(int, width);
  QFETCH(int, rows);
  ChartHeading heading(nullptr);
  heading.setLook(look());
  heading.setContent(twoRuns());

  QCOMPARE(heading.layOut(width), static_cast<double>(rows * kRow));
  QTEST(rowsWithMarks(painted(heading)), "rowsWithRuns");
}

void ChartHeadingTest::keepsRunsApartFromALegendOfSeveralRows() {
  HeadingContent content = twoRuns();
  content.runs.pop_back();
  ChartHeading heading(nullptr);
  heading.setLook(look());
  heading.setContent(content);
  // The last word of the legend alone in its row would leave room for the run.
  QCOMPARE(heading.layOut(360), 3.0 * kRow);
}

void ChartHeadingTest::takesOneRowPerRunWhereRoomIsScarce() {
  ChartHeading heading(nullptr);
  heading.setLook(look());
  heading.setContent(twoRuns());
  // As narrow as where figures stand below names: two rows of legend, one for each run.
  constexpr int kCompactRow = 24;
  QCOMPARE(heading.layOut(250, ui::HeadingDensity::kCompact), 4.0 * kCompactRow);
  QCOMPARE(rowsWithMarks(painted(heading)), 2);
  QCOMPARE(heading.layOut(250), 6.0 * kRow);
}

void ChartHeadingTest::takesNoRoomWhenEmpty() {
  ChartHeading heading(nullptr);
  heading.setLook(look());
  QCOMPARE(heading.layOut(400), 0.0);
}

void ChartHeadingTest::keepsItsPlacesWhenFiguresChange() {
  HeadingContent content = twoRuns();
  for (HeadingEntry& run : content.runs) run.widestFigures = "drift −0.000000 J";
  ChartHeading heading(nullptr);
  heading.setLook(look());
  heading.setContent(content);
  heading.layOut(900);
  const QImage before = painted(heading);
  content.runs[0].figures = "drift +1.2345 J";
  heading.setContent(content);
  heading.layOut(900);
  const QImage after = painted(heading);

  // From the second run's mark on nothing has moved.
  const QRect right(500, 0, 400, before.height());
  QVERIFY(before != after);
  QCOMPARE(after.copy(right), before.copy(right));
}

void ChartHeadingTest::putsTitleNoteAndWarningInRowsOfTheirOwn() {
  HeadingContent content = twoRuns();
  ChartHeading heading(nullptr);
  heading.setLook(look());
  heading.setContent(content);
  double height = heading.layOut(900);
  for (QString HeadingContent::*line :
       {&HeadingContent::title, &HeadingContent::note, &HeadingContent::warning}) {
    content.*line = "Words";
    heading.setContent(content);
    const double taller = heading.layOut(900);
    QVERIFY(taller > height + 20);
    height = taller;
  }
}

QTEST_MAIN(ChartHeadingTest)
#include "chart_heading_test.moc"
