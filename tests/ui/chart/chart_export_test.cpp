#include "ui/chart/chart_export.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImageReader>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/support/file_content.h"
#include "tests/ui/chart/sample_ledgers.h"
#include "ui/style/theme.h"

using core::Ledger;
using tests::contentOf;

namespace {

const ui::ChartCaption kCaption = {"Seven weights", "Air at 1.2 kg/m³"};

QStringList textsIn(const QString& svgFile) {
  QStringList texts;
  QXmlStreamReader reader(contentOf(svgFile));
  while (!reader.atEnd()) {
    reader.readNext();
    if (reader.isStartElement() && reader.name() == QStringLiteral("text")) {
      texts.append(reader.readElementText());
    }
  }
  return texts;
}

bool contains(const QImage& image, const QColor& color) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y) == color) return true;
    }
  }
  return false;
}

/// Whether a border as wide as this [px] is white all around.
bool hasWhiteBorder(const QImage& image, int width) {
  QImage blank = image;
  blank.fill(Qt::white);
  const QRect inside = image.rect().adjusted(width, width, -width, -width);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!inside.contains(x, y) && image.pixelColor(x, y) != Qt::white) return false;
    }
  }
  return true;
}

}  // namespace

class ChartExportTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void writesPngAt300DotsPerInch();
  void writesSvgWithItsTexts();
  void drawsInsideTheSvgOnly();
  void writesPdfInTheSizeOfTheChart();
  void looksTheSameInDarkWindows();
  void goesByTheEndingInAnyCase();
  void refusesInWords_data();
  void refusesInWords();
  void keepsTheOldFileWhenWritingFails();
  void writesRunsWithoutSamples();

 private:
  QString path(const QString& name) const { return m_folder.filePath(name); }
  QString write(const QString& name) const {
    return ui::writeEnergyChart(path(name), m_runs, kCaption);
  }

  QTemporaryDir m_folder;
  Ledger m_steady = sample_ledgers::swinging(4, 401);
  Ledger m_diverging = sample_ledgers::diverging();
  std::vector<ui::ChartedRun> m_runs = {{&m_steady, "RK4, 1/60 s"}, {&m_diverging, "Euler, 1 s"}};
};

void ChartExportTest::initTestCase() {
  QLocale::setDefault(QLocale(QLocale::English));
  QVERIFY(m_folder.isValid());
}

void ChartExportTest::writesPngAt300DotsPerInch() {
  QCOMPARE(write("chart.png"), QString());
  const QImage image = QImageReader(path("chart.png")).read();

  QCOMPARE(image.size(), QSize(1890, 1181));  // 160 mm × 100 mm
  QCOMPARE(image.dotsPerMeterX(), 11811);     // 300 / 0.0254
  QCOMPARE(image.dotsPerMeterY(), 11811);
  QVERIFY(hasWhiteBorder(image, 12));  // nothing is cut off
  QVERIFY(!hasWhiteBorder(image.copy(image.width() * 9 / 10, 0, 180, image.height()), 40));
  QVERIFY(contains(image, ui::Theme::light().potential));
  QVERIFY(contains(image, ui::Theme::light().total));
}

void ChartExportTest::writesSvgWithItsTexts() {
  QCOMPARE(write("chart.svg"), QString());
  QSvgRenderer renderer(path("chart.svg"));
  QVERIFY(renderer.isValid());

  const QStringList texts = textsIn(path("chart.svg"));
  for (const char* text : {"Seven weights", "Air at 1.2 kg/m³", "Kinetic", "Potential", "Total",
                           "Lost to air", "Lost to impacts", "RK4, 1/60 s", "Euler, 1 s",
                           "drift 0 J (0 %)", "Time (s)", "Energy (J)"}) {
    QVERIFY2(texts.contains(QString::fromUtf8(text)), qPrintable(texts.join('|')));
  }
  const QByteArray svg = contentOf(path("chart.svg"));
  QVERIFY(svg.contains("<title>Seven weights</title>"));
  QVERIFY(svg.count("<polyline") < 100);  // ticks and grid; each curve is one path
  QVERIFY(svg.contains("width=\"160.02mm\" height=\"100.076mm\""));
}

void ChartExportTest::drawsInsideTheSvgOnly() {
  QCOMPARE(write("inside.svg"), QString());
  QSvgRenderer renderer(path("inside.svg"));
  QImage image(945, 591, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  renderer.render(&painter);
  painter.end();
  QVERIFY(hasWhiteBorder(image, 6));

  // The diverging run's curves end at the top of the scale though nothing clips them:
  // above the plot's top, and right of the heading, all is white.
  QVERIFY(!contains(image.copy(600, 0, 345, 60), ui::Theme::light().kinetic));
}

void ChartExportTest::writesPdfInTheSizeOfTheChart() {
  QCOMPARE(write("chart.pdf"), QString());
  const QByteArray pdf = contentOf(path("chart.pdf"));

  QVERIFY(pdf.startsWith("%PDF-1."));
  QVERIFY(pdf.trimmed().endsWith("%%EOF"));
  const QRegularExpression box(R"(/MediaBox \[0 0 ([\d.]+) ([\d.]+)\])");
  const QRegularExpressionMatch match = box.match(QString::fromLatin1(pdf));
  QVERIFY(match.hasMatch());
  // Pages are in whole points, 1/72 inch.
  QVERIFY(std::abs(match.captured(1).toDouble() - 160 / 25.4 * 72) < 1);
  QVERIFY(std::abs(match.captured(2).toDouble() - 100 / 25.4 * 72) < 1);
  QCOMPARE(pdf.count("/Type /Page\n"), 1);
  QVERIFY(pdf.contains("/FontFile2"));  // embedded
  QVERIFY(!pdf.contains("/Subtype /Image"));
}

void ChartExportTest::looksTheSameInDarkWindows() {
  QCOMPARE(write("light.png"), QString());
  const QPalette before = QGuiApplication::palette();
  QGuiApplication::setPalette(QPalette(Qt::black));
  const QString failure = write("dark.png");
  QGuiApplication::setPalette(before);

  QCOMPARE(failure, QString());
  QCOMPARE(QImage(path("dark.png")), QImage(path("light.png")));
}

void ChartExportTest::goesByTheEndingInAnyCase() {
  QCOMPARE(write("CHART.PNG"), QString());
  QCOMPARE(QImageReader(path("CHART.PNG")).format(), QByteArray("png"));
}

void ChartExportTest::refusesInWords_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("reason");
  const QString ending = "a chart's file ends in .png, .svg or .pdf";
  QTest::newRow("unknown ending") << "chart.bmp" << ending;
  QTest::newRow("no ending") << "chart" << ending;
  QTest::newRow("no such folder") << "nowhere/chart.png"
                                  << "No such file or directory";
}

void ChartExportTest::refusesInWords() {
  QFETCH(QString, name);
  QFETCH(QString, reason);
  QCOMPARE(write(name), reason);
  QVERIFY(!QFile::exists(path(name)));
}

void ChartExportTest::keepsTheOldFileWhenWritingFails() {
  // A folder stands where the file would be renamed to.
  QVERIFY(QDir(m_folder.path()).mkpath("taken.pdf"));
  QFile kept(path("taken.pdf/kept"));
  QVERIFY(kept.open(QIODevice::WriteOnly));
  kept.close();
  const QStringList before = QDir(m_folder.path()).entryList();

  QVERIFY(!write("taken.pdf").isEmpty());
  QVERIFY(kept.exists());
  QCOMPARE(QDir(m_folder.path()).entryList(), before);
}

void ChartExportTest::writesRunsWithoutSamples() {
  const Ledger empty;
  for (const char* name : {"empty.png", "empty.svg", "empty.pdf"}) {
    QCOMPARE(ui::writeEnergyChart(path(name), {{&empty, "RK4"}}, {}), QString());
    QVERIFY(!contentOf(path(name)).isEmpty());
  }
}

QTEST_MAIN(ChartExportTest)
#include "chart_export_test.moc"
