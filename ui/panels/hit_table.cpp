#include "ui/panels/hit_table.h"

#include <QHeaderView>

#include "ui/chart/figure_text.h"

namespace ui {
namespace {

/// Below the heading "Off a".
QString hitWords(core::FirstHit hit) {
  switch (hit) {
    case core::FirstHit::kNothing:
      break;
    case core::FirstHit::kWall:
      return HitTable::tr("wall");
    case core::FirstHit::kWeight:
      return HitTable::tr("weight");
  }
  return {};
}

}  // namespace

HitTable::HitTable(QWidget* parent) : QTableWidget(parent) {
  const QStringList headings{tr("Cut at"), tr("Lasts"), tr("Lands"), tr("Off a")};
  const QStringList tips{tr("The moment that comes nearest to the target's center"),
                         tr("How long the stretch of cut times is that hit"),
                         tr("When the weight lands"), tr("What it hits first, before the floor")};
  setColumnCount(static_cast<int>(headings.size()));
  setHorizontalHeaderLabels(headings);
  for (int i = 0; i < tips.size(); ++i) horizontalHeaderItem(i)->setToolTip(tips[i]);
  verticalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(columnCount() - 1, QHeaderView::Stretch);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);  // Tab leaves it again
  setAlternatingRowColors(true);
  setAccessibleName(tr("Moments that hit"));
  setToolTip(tr("Double-click a row, or press Return, to cut then"));
  setAccessibleDescription(toolTip());
  connect(this, &QTableWidget::cellActivated, this,
          [this](int row) { emit momentPicked(m_moments[static_cast<std::size_t>(row)]); });
}

void HitTable::setHits(const std::vector<core::Hit>& hits) {
  setRowCount(0);
  m_moments.clear();
  for (const core::Hit& hit : hits) addRow(hit);
}

void HitTable::addRow(const core::Hit& hit) {
  constexpr double kMilliseconds = 1000;
  const QStringList texts{tr("%1 s").arg(cutTimeText(hit.best)),
                          tr("%1 ms").arg(figure(kMilliseconds * (hit.until - hit.from))),
                          tr("%1 s").arg(cutTimeText(hit.landsAt)), hitWords(hit.firstHit)};
  const int row = rowCount();
  insertRow(row);
  for (int column = 0; column < texts.size(); ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    const bool isFigure = column + 1 < texts.size();
    item->setTextAlignment(Qt::AlignVCenter | (isFigure ? Qt::AlignRight : Qt::AlignLeft));
    setItem(row, column, item);
  }
  m_moments.push_back(hit.best);
}

}  // namespace ui
