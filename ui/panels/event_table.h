#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <QAbstractTableModel>

#include "core/recording/event_log.h"
#include "ui/control/event_words.h"
#include "ui/style/theme.h"

namespace ui {

/// The events of one run as a table, for a view that asks only for the rows it shows. Follows
/// its log when told to; knows no time.
class EventTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kKind, kWho, kSpeedBefore, kSpeedAfter, kEnergyLost, kColumnCount };

  explicit EventTable(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  /// @param log  must outlive the model or the next call
  void setLog(const core::EventLog* log);
  /// Lists only these.
  /// @param weight  index; −1: all
  void setFilter(EventGroup group, int weight);
  /// Colors of the signs.
  void setTheme(const Theme& theme);

  /// Takes up what the log has got or lost since.
  void refresh();

  const core::Event& eventAt(int row) const { return m_log->events()[m_rows[row]]; }
  /// The last row whose event is not after `time` [s]; −1 if there is none.
  int rowAt(double time) const;
  /// These rows with a header line, as `simulate --events` writes them.
  std::string csv(std::span<const int> rows) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  bool isListed(const core::Event& event) const;
  void listAnew();
  void listFrom(std::size_t first, std::vector<std::uint32_t>& rows) const;
  static QString meaningOf(int column);
  QString textOf(const core::Event& event, int column) const;

  const core::EventLog* m_log = nullptr;
  EventGroup m_group = EventGroup::kAll;
  int m_weight = -1;
  Theme m_theme = Theme::light();
  std::vector<std::uint32_t> m_rows;  // indices into the log's events
  std::size_t m_seen = 0;             // events of the log that have been looked at
  std::uint64_t m_revision = 0;       // of the log then
};

}  // namespace ui
