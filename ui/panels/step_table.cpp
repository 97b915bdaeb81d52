#include "ui/panels/step_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

#include "ui/chart/figure_text.h"
#include "ui/control/run_words.h"

namespace ui {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kLargestDenominator = 100;
constexpr int kDigits = 7;

/// The smallest denominator that makes all shares whole numbers; 0 if it would be large.
int commonDenominator(const core::Method& method) {
  for (int denominator = 1; denominator <= kLargestDenominator; ++denominator) {
    const bool fits = std::ranges::all_of(method.shares, [&](double share) {
      return std::abs(share * denominator - std::round(share * denominator)) < 1e-9;
    });
    if (fits) return denominator;
  }
  return 0;
}

QString shareText(const core::Stage& stage, const core::Method& method) {
  if (!stage.share) return {};
  const int denominator = commonDenominator(method);
  if (denominator == 1) return QString::number(std::lround(*stage.share));
  if (denominator > 0)
    return QStringLiteral("%1/%2").arg(std::lround(*stage.share * denominator)).arg(denominator);
  return QLocale().toString(*stage.share, 'f', 4).replace('-', QChar(0x2212));
}

/// With as many decimals as make up so many digits of the largest of them.
QString aligned(double value, double largest) {
  const int power = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  const int decimals = std::clamp(kDigits - 1 - power, 0, kDigits + 2);
  return QLocale().toString(value, 'f', decimals).replace('-', QChar(0x2212));
}

}  // namespace

std::vector<StateQuantity> stateQuantities(core::Mode mode) {
  switch (mode) {
    case core::Mode::kSwing:
    case core::Mode::kHeld:
      return {{0, QStringLiteral("θ"), QStringLiteral("°"), QStringLiteral("°/s"), kDegree},
              {2, QStringLiteral("ω"), QStringLiteral("°/s"), QStringLiteral("°/s²"), kDegree}};
    case core::Mode::kSlide:
      return {{0, QStringLiteral("x"), QStringLiteral("m"), QStringLiteral("m/s"), 1},
              {2, QStringLiteral("vx"), QStringLiteral("m/s"), QStringLiteral("m/s²"), 1}};
    case core::Mode::kFlight:
      break;
  }
  return {{0, QStringLiteral("x"), QStringLiteral("m"), QStringLiteral("m/s"), 1},
          {1, QStringLiteral("y"), QStringLiteral("m"), QStringLiteral("m/s"), 1},
          {2, QStringLiteral("vx"), QStringLiteral("m/s"), QStringLiteral("m/s²"), 1},
          {3, QStringLiteral("vy"), QStringLiteral("m/s"), QStringLiteral("m/s²"), 1}};
}

StateQuantity plottedQuantity(core::Mode mode) {
  return stateQuantities(mode)[mode == core::Mode::kFlight ? 1 : 0];
}

QString stageName(std::size_t index) {
  return QStringLiteral("k%1").arg(index + 1);
}

StepTable::StepTable(QWidget* parent) : QTableWidget(parent) {
  setAccessibleName(tr("The step in numbers"));
  setAccessibleDescription(
      tr("The slopes that the method took on its way, and where other methods end"));
  setToolTip(accessibleDescription());
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::TabFocus);
  setTabKeyNavigation(false);  // Tab leaves it again
  setFrameShape(QFrame::NoFrame);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 2);
  verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void StepTable::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 2);
}

void StepTable::clearPart() {
  setRowCount(0);
  setColumnCount(0);
}

void StepTable::showPart(const core::StepPart& part, const core::Method& method,
                         const core::ExactWay& exact, const std::vector<core::StepEnd>& ends) {
  std::vector<Line> lines;
  lines.push_back({tr("Start"), part.beginState, false, {}, {}});
  for (std::size_t i = 0; i < part.stages.size(); ++i)
    lines.push_back(
        {stageName(i), part.stages[i].slope, true, shareText(part.stages[i], method), {}});
  lines.push_back({tr("Mean slope"), part.meanSlope(), true, {}, {}});
  for (const core::StepEnd& end : ends)
    lines.push_back(
        {tr("End, %1").arg(methodWords(*end.method)), end.state, false, {}, figure(end.error)});
  lines.push_back({tr("End, exact"), exact.end(), false, {}, QStringLiteral("0")});
  showLines(lines, part.mode);
  verticalHeaderItem(rowCount() - 1)->setToolTip(tr("By a Taylor series from the same start"));
}

void StepTable::showLines(const std::vector<Line>& lines, core::Mode mode) {
  const std::vector<StateQuantity> quantities = stateQuantities(mode);
  const int count = static_cast<int>(quantities.size());
  setRowCount(static_cast<int>(lines.size()));
  setColumnCount(count + 2);
  QStringList headers{tr("Share")};
  for (const StateQuantity& quantity : quantities)
    headers << tr("%1 in %2\nslope in %3").arg(quantity.symbol, quantity.unit, quantity.slopeUnit);
  setHorizontalHeaderLabels(headers << tr("Error\nin m"));
  horizontalHeaderItem(0)->setToolTip(
      tr("Share of the slope in the mean that the step is taken with"));
  for (int i = 0; i < count; ++i)
    horizontalHeaderItem(i + 1)->setToolTip(
        tr("%1 at the start and the end, and as a slope how fast it changes")
            .arg(quantities[i].symbol));
  horizontalHeaderItem(count + 1)->setToolTip(
      tr("Distance of the end from the exact one, in m: the error of this step alone"));
  // A header keeps a smaller font of its own.
  horizontalHeader()->setFont(font());
  for (int row = 0; row < rowCount(); ++row) {
    const Line& line = lines[static_cast<std::size_t>(row)];
    if (!verticalHeaderItem(row)) setVerticalHeaderItem(row, new QTableWidgetItem);
    verticalHeaderItem(row)->setText(line.name);
    set(row, 0, line.share);
    for (int i = 0; i < count; ++i) {
      const StateQuantity& quantity = quantities[static_cast<std::size_t>(i)];
      double largest = 0;
      for (const Line& other : lines)
        if (other.isSlope == line.isSlope)
          largest = std::max(largest, std::abs(other.entries[quantity.entry]) / quantity.size);
      set(row, i + 1, aligned(line.entries[quantity.entry] / quantity.size, largest));
    }
    set(row, count + 1, line.error);
  }
}

void StepTable::set(int row, int column, const QString& text) {
  if (!item(row, column)) {
    auto* cell = new QTableWidgetItem;
    cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, column, cell);
  }
  if (item(row, column)->text() != text) item(row, column)->setText(text);
}

}  // namespace ui
