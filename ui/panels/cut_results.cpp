#include "ui/panels/cut_results.h"

#include <string>
#include <utility>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/chart/cut_sweep_chart.h"
#include "ui/control/file_dialog.h"
#include "ui/files/output_file.h"
#include "ui/panels/export_button.h"
#include "ui/panels/export_message.h"
#include "ui/panels/hit_table.h"
#include "ui/style/icons.h"

namespace ui {

CutResults::CutResults(QWidget* parent)
    : QWidget(parent),
      m_export(new ExportButton(
          [this] { return fileNameFrom(m_result->sceneName) + '-' + tr("when-to-cut"); })),
      m_chart(new CutSweepChart),
      m_table(new HitTable),
      m_found(new QLabel) {
  addCopying();
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->addWidget(m_chart);
  splitter->addWidget(m_table);
  constexpr int kChartShare = 640, kTableShare = 360;
  splitter->setSizes({kChartShare, kTableShare});
  m_found->setWordWrap(true);
  m_found->setContentsMargins(12, 6, 12, 10);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(splitter, 1);
  layout->addWidget(m_found);
  connect(m_export, &ExportButton::chartWanted, this, &CutResults::saveChart);
  connect(m_export, &ExportButton::tableWanted, this, &CutResults::saveTable);
  connect(m_chart, &CutSweepChart::momentPicked, this, &CutResults::momentPicked);
  connect(m_table, &HitTable::momentPicked, this, &CutResults::momentPicked);
  setResult(nullptr);
}

void CutResults::addCopying() {
  QMenu* menu = m_export->menu();
  menu->addSeparator();
  QAction* copyPicture =
      menu->addAction(icon("picture"), tr("Copy chart"), this, &CutResults::copyChart);
  QAction* copyFigures =
      menu->addAction(icon("table"), tr("Copy chart data"), this, &CutResults::copyData);
  copyPicture->setShortcut(QKeySequence("Ctrl+Shift+C"));
  copyFigures->setShortcut(QKeySequence("Ctrl+Shift+D"));
  addActions({copyPicture, copyFigures});
}

void CutResults::setResult(std::shared_ptr<const CutSweepResult> result) {
  m_result = std::move(result);
  m_export->setEnabled(m_result != nullptr);
  m_chart->setResult(m_result);
  m_table->setHits(m_result ? m_result->hits : std::vector<core::Hit>());
  m_found->setText(m_result
                       ? foundWords(*m_result)
                       : tr("Finds where the weight first comes to the floor for every moment of "
                            "the cut, and the moments that hit the target."));
}

void CutResults::showTarget(const core::Target& target) {
  auto moved = std::make_shared<CutSweepResult>(*m_result);
  moved->target = target;
  moved->hits.clear();
  m_result = std::move(moved);
  m_chart->setResult(m_result);
  m_table->setHits({});
}

void CutResults::say(const QString& words) {
  m_found->setText(words);
}

void CutResults::saveChart(const QString& file) {
  sayIfNotExported(this, file, writeCutSweepChart(file, m_result));
}

void CutResults::saveTable(const QString& file) {
  const std::string table = sweepTable(*m_result, ',', QStringLiteral(".")).toStdString();
  sayIfNotExported(this, file, writeWhole(file, table));
}

void CutResults::copyChart() const {
  if (m_result) QGuiApplication::clipboard()->setImage(cutSweepImage(m_result));
}

void CutResults::copyData() const {
  if (!m_result) return;
  auto* table = new QMimeData;
  table->setText(sweepTable(*m_result, '\t', QLocale().decimalPoint()));
  table->setData(QStringLiteral("text/csv"),
                 sweepTable(*m_result, ',', QStringLiteral(".")).toUtf8());
  QGuiApplication::clipboard()->setMimeData(table);
}

}  // namespace ui
