#include "ui/chart/plot_heading.h"

#include <algorithm>

#include "ui/chart/energy_extent.h"
#include "ui/chart/energy_figures.h"
#include "ui/chart/run_pen.h"

namespace ui {

namespace {

constexpr std::size_t kMostEntries = 12;
constexpr double kBandWidth = 12;  // of a band's sign in the legend [px]

/// The curve's line, or a short piece of its band.
QPen legendPen(const ChartCurve& curve) {
  if (curve.style == CurveStyle::kLine) return runPen(curve.color, curve.width, 0);
  QPen pen(curve.color, kBandWidth);
  pen.setCapStyle(Qt::FlatCap);
  if (curve.style == CurveStyle::kHatched) pen.setDashPattern({0.15, 0.25});
  return pen;
}

std::vector<HeadingEntry> legend(const std::vector<ChartCurve>& curves,
                                 const std::vector<bool>& shown, const HiddenCurves& hidden,
                                 const QString& offset) {
  std::vector<HeadingEntry> entries;
  for (const ChartCurve* curve : legendCurves(curves)) {
    bool hasAnything = false;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      hasAnything |= curves[i].name == curve->name && shown[i];
    }
    if (!hasAnything) continue;
    HeadingEntry entry;
    entry.key = curve->name;
    entry.line = legendPen(*curve);
    const bool isMoved = curve->holdsPotential && curve->style == CurveStyle::kLine;
    entry.text = isMoved ? curve->name + offset : curve->name;
    entry.hidden = hidden.names.contains(curve->name);
    entries.push_back(entry);
  }
  return entries;
}

std::vector<HeadingEntry> runEntries(const ChartSubject& subject, const ChartContent& content,
                                     const HiddenCurves& hidden, const Theme& theme) {
  constexpr double kLineWidth = 2;
  std::vector<HeadingEntry> entries;
  for (std::size_t i = 0; i < subject.runs.size(); ++i) {
    HeadingEntry entry;
    entry.run = i;
    const std::size_t place = subject.firstRun + i;
    entry.mark = theme.runs[place % theme.runs.size()];
    entry.markFilled = place == 0;
    entry.line = runPen(theme.text, kLineWidth, place);
    entry.text = subject.runs[i].name;
    entry.hidden = hidden.runs.contains(i);
    if (content.energies) {
      entry.figures = driftText(*subject.runs[i].ledger);
      entry.widestFigures = widestDriftText();
    }
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace

std::vector<const ChartCurve*> legendCurves(const std::vector<ChartCurve>& curves) {
  std::vector<const ChartCurve*> found;
  for (const ChartCurve& curve : curves) {
    const bool isNew = std::ranges::none_of(
        found, [&](const ChartCurve* other) { return other->name == curve.name; });
    if (isNew) found.push_back(&curve);
  }
  if (found.size() > kMostEntries) found.clear();
  return found;
}

HeadingContent plotHeading(const ChartSubject& subject, const ChartContent& content,
                           const std::vector<bool>& shown, const HiddenCurves& hidden,
                           const EnergyExtent& extent, const AxisScale& vertical,
                           const Theme& theme) {
  const QString offset = content.energies ? offsetText(extent, vertical) : QString();
  HeadingContent heading;
  heading.legend = legend(content.curves, shown, hidden, offset);
  heading.runs = runEntries(subject, content, hidden, theme);
  QStringList remarks;
  if (!content.note.isEmpty()) remarks << content.note;
  if (content.energies) remarks << ceilingWarning(subject.runs, extent, vertical);
  remarks.removeAll(QString());
  heading.warning = remarks.join(QStringLiteral(" · "));
  return heading;
}

}  // namespace ui
