#pragma once

#include <QWidget>

class QComboBox;
class QSpinBox;
class QTableView;

namespace ui {

class EventNavigator;
class EventTable;
class RunController;

/// The list of what happened in one run. Follows the moment shown; choosing an event shows
/// its moment.
class EventsPanel : public QWidget {
  Q_OBJECT

 public:
  EventsPanel(RunController* controller, EventNavigator* events, QWidget* parent = nullptr);

  /// Chooses what is listed, wherever it is laid out.
  QWidget* filters() const { return m_filters; }

  /// Index of the weight whose events are listed; −1: all.
  int weight() const;

 public slots:
  /// Lists the events of one weight only.
  /// @param weight  index; −1: all
  void setWeight(int weight);

 signals:
  /// Something went well, in words.
  void done(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void buildTable();
  void buildFilters();
  void fitToFont();
  int kindWidth() const;
  void listRuns();
  void applyFilter();
  void follow();
  void goToCurrent();
  void copy();

  RunController* m_controller;
  EventNavigator* m_events;
  EventTable* m_table;
  QTableView* m_view;
  QWidget* m_filters;
  QComboBox* m_kinds;
  QSpinBox* m_weight;
  QComboBox* m_runs;
  bool m_isFollowing = false;  // the current row moves with time, not by the user's hand
};

}  // namespace ui
