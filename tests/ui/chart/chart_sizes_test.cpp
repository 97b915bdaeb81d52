#include <array>

#include <QChart>
#include <QGraphicsScene>
#include <QGraphicsTextItem>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/support/file_content.h"
#include "tests/support/settle.h"
#include "tests/ui/chart/recorded_scene.h"
#include "ui/chart/chart_export.h"
#include "ui/chart/chart_kind.h"
#include "ui/chart/chart_plot.h"

namespace {

constexpr std::array kOfferedSizes{QSize(160, 100), QSize(80, 60), QSize(254, 143),
                                   QSize(420, 297)};  // [mm]

/// All texts of an SVG drawing, one after the other and without spaces: where the script changes
/// a text is written in pieces.
QString textsIn(const QString& svgFile) {
  QXmlStreamReader reader(tests::contentOf(svgFile));
  QString texts;
  while (!reader.atEnd()) {
    if (reader.readNext() == QXmlStreamReader::StartElement && reader.name() == u"text")
      texts += reader.readElementText().remove(' ').trimmed();
  }
  return texts;
}

const ui::ChartKind& kindOf(int index) {
  return ui::chartKinds()[static_cast<std::size_t>(index)];
}

/// What an axis says when it has room: "x (m)".
QString titleOf(const ui::ChartAxis& axis) {
  return QString("%1(%2)").arg(axis.quantity, axis.unit);
}

}  // namespace

/// Charts of seven weights under two methods, in every size in which they are met.
class ChartSizesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void saysOnPaperWhatItShows_data();
  void saysOnPaperWhatItShows();
  void hasRoomForItsCurvesInALowWindow_data();
  void hasRoomForItsCurvesInALowWindow();

 private:
  QTemporaryDir m_folder;
  RecordedScene m_scene{7, 1.5, {{.method = "rk4"}, {.method = "euler"}}};
};

void ChartSizesTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  m_scene.runUntil(4);
}

void ChartSizesTest::saysOnPaperWhatItShows_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<QSize>("size");
  for (std::size_t i = 0; i < ui::chartKinds().size(); ++i)
    for (const QSize size : kOfferedSizes)
      QTest::addRow("%s, %d x %d mm", ui::chartKinds()[i].id, size.width(), size.height())
          << static_cast<int>(i) << size;
}

void ChartSizesTest::saysOnPaperWhatItShows() {
  QFETCH(int, kind);
  QFETCH(QSize, size);
  const ui::ChartSubject subject = m_scene.subject({0});
  const QString file = m_folder.filePath("chart.svg");
  QCOMPARE(
      ui::writeChartPicture(file, {&kindOf(kind), subject, {}, {}}, {"Seven weights", {}}, size),
      QString());
  const QString texts = textsIn(file);
  const ui::ChartContent content = kindOf(kind).content(subject, ui::Theme::light());
  QVERIFY2(texts.contains("Sevenweights"), qPrintable(texts));
  // Below the seven lines of a ledger's heading half a page has no room for titles, but for the
  // unit at each number.
  const bool isCrowded = size.width() == 80 && QString(kindOf(kind).id) == "ledger";
  QVERIFY2(texts.contains(isCrowded ? "0s" : titleOf(content.horizontal)), qPrintable(texts));
  QVERIFY2(texts.contains(isCrowded ? "0J" : titleOf(content.vertical)), qPrintable(texts));
  for (const char* run : {"run1", "run2"}) QVERIFY2(texts.contains(run), qPrintable(texts));
}

void ChartSizesTest::hasRoomForItsCurvesInALowWindow_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<bool>("ofAll");
  for (std::size_t i = 0; i < ui::chartKinds().size(); ++i) {
    const ui::ChartKind& kind = ui::chartKinds()[i];
    QTest::addRow("%s", kind.id) << static_cast<int>(i) << false;
    if (kind.ofWeights) QTest::addRow("%s of all", kind.id) << static_cast<int>(i) << true;
  }
}

/// As in a window of 960 × 540.
void ChartSizesTest::hasRoomForItsCurvesInALowWindow() {
  QFETCH(int, kind);
  QFETCH(bool, ofAll);
  const QSize size(540, 108);
  QGraphicsScene scene;
  auto* chart = new QChart;
  scene.addItem(chart);
  auto* plot = new ui::ChartPlot(chart);
  plot->setLook(ui::ChartLook::forScreen(ui::Theme::light(), {}));
  plot->setSubject(kindOf(kind),
                   m_scene.subject(ofAll ? std::vector{0, 1, 2, 3, 4, 5, 6} : std::vector{0}));
  chart->resize(size);
  tests::settle();
  QVERIFY2(chart->plotArea().height() >= 0.4 * size.height(),
           qPrintable(QString::number(chart->plotArea().height())));
  QVERIFY(3 * chart->plotArea().width() >= size.width());
  for (const QGraphicsItem* item : scene.items()) {
    const auto* text = qgraphicsitem_cast<const QGraphicsTextItem*>(item);
    if (text) QVERIFY2(!text->toPlainText().contains("..."), qPrintable(text->toPlainText()));
  }
}

QTEST_MAIN(ChartSizesTest)
#include "chart_sizes_test.moc"
