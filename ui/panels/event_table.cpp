#include "ui/panels/event_table.h"

#include <algorithm>

#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPixmap>

#include "core/recording/csv.h"
#include "ui/chart/figure_text.h"
#include "ui/style/event_mark.h"

namespace ui {
namespace {

constexpr int kMark = 16;  // px
constexpr int kTimeDecimals = 4;

QPixmap markOf(core::EventKind kind, const Theme& theme) {
  QPixmap picture(2 * kMark, 2 * kMark);
  picture.setDevicePixelRatio(2);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  drawEventMark(painter, kind, {kMark / 2.0, kMark / 2.0}, kMark - 3, theme);
  return picture;
}

}  // namespace

void EventTable::setLog(const core::EventLog* log) {
  m_log = log;
  listAnew();
}

void EventTable::setFilter(EventGroup group, int weight) {
  if (group == m_group && weight == m_weight) return;
  m_group = group;
  m_weight = weight;
  listAnew();
}

void EventTable::setTheme(const Theme& theme) {
  m_theme = theme;
  if (!m_rows.empty())
    emit dataChanged(index(0, kKind), index(rowCount() - 1, kKind), {Qt::DecorationRole});
}

bool EventTable::isListed(const core::Event& event) const {
  const bool concerns =
      m_weight < 0 || event.weight < 0 || event.weight == m_weight || event.other == m_weight;
  return concerns && belongsTo(m_group, event.kind);
}

void EventTable::listFrom(std::size_t first, std::vector<std::uint32_t>& rows) const {
  const auto events = m_log->events();
  for (std::size_t i = first; i < events.size(); ++i) {
    if (isListed(events[i])) rows.push_back(static_cast<std::uint32_t>(i));
  }
}

void EventTable::listAnew() {
  beginResetModel();
  m_rows.clear();
  if (m_log) {
    listFrom(0, m_rows);
    m_seen = m_log->events().size();
    m_revision = m_log->revision();
  }
  endResetModel();
}

void EventTable::refresh() {
  if (!m_log) return;
  if (m_log->revision() != m_revision) return listAnew();
  std::vector<std::uint32_t> added;
  listFrom(std::exchange(m_seen, m_log->events().size()), added);
  if (added.empty()) return;
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(added.size()) - 1);
  m_rows.insert(m_rows.end(), added.begin(), added.end());
  endInsertRows();
}

int EventTable::rowAt(double time) const {
  const auto later = std::ranges::upper_bound(
      m_rows, time, {}, [this](std::uint32_t row) { return m_log->events()[row].time; });
  return static_cast<int>(later - m_rows.begin()) - 1;
}

std::string EventTable::csv(std::span<const int> rows) const {
  std::string text(core::eventHeader());
  for (const int row : rows) core::appendEventRow(text, eventAt(row));
  return text;
}

int EventTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EventTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

QString EventTable::textOf(const core::Event& event, int column) const {
  // All ropes cut at once: no one weight has a speed.
  const bool hasSpeed = event.weight >= 0;
  switch (column) {
    case kTime:
      return QLocale().toString(event.time, 'f', kTimeDecimals);
    case kKind:
      return eventWords(event.kind);
    case kWho:
      return whoWords(event);
    case kSpeedBefore:
      return hasSpeed ? figure(event.speedBefore) : QString();
    case kSpeedAfter:
      return hasSpeed ? figure(event.speedAfter) : QString();
    default:
      return figure(event.energyLost);
  }
}

QVariant EventTable::data(const QModelIndex& index, int role) const {
  const core::Event& event = eventAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return textOf(event, index.column());
    case Qt::DecorationRole:
      return index.column() == kKind ? QVariant(markOf(event.kind, m_theme)) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant((index.column() == kKind ? Qt::AlignLeft : Qt::AlignRight) |
                      Qt::AlignVCenter);
    default:
      return {};
  }
}

QString EventTable::meaningOf(int column) {
  const QString meanings[] = {
      tr("When it happened, t in s"),
      tr("What happened"),
      tr("The weights it happened to, counted from the left"),
      tr("Speed |v| right before, in m/s. Of the weight; where two meet, of the first named"),
      tr("Speed |v| right after, in m/s. Of the weight; where two meet, of the first named"),
      tr("Kinetic energy turned into heat by the event, in J. Between two weights "
         "½ (1 − e²) μ v², with the speed v towards each other and 1/μ = 1/m₁ + 1/m₂")};
  return meanings[column];
}

QVariant EventTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::ToolTipRole) return meaningOf(section);
  if (role != Qt::DisplayRole) return {};
  const QString names[] = {tr("Time (s)"),     tr("Event"),       tr("Weight"),
                           tr("Before (m/s)"), tr("After (m/s)"), tr("Energy lost (J)")};
  return names[section];
}

}  // namespace ui
