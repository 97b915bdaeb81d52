#pragma once

#include <QTableWidget>

#include "core/run/step_stages.h"
#include "core/trade/step_ends.h"

namespace ui {

/// One entry of a weight's state as it is shown.
struct StateQuantity {
  int entry;          ///< in core::Entries
  QString symbol;     ///< "θ"
  QString unit;       ///< "°"
  QString slopeUnit;  ///< "°/s"
  double size;        ///< of the unit in the core's: π/180 for degrees
};

/// What there is to show of a weight that moves so: θ and ω, or x, y and their rates.
std::vector<StateQuantity> stateQuantities(core::Mode mode);

/// Which of them a plot over time shows: θ, or the height; along the floor the place.
StateQuantity plottedQuantity(core::Mode mode);

/// "k1", as the stages are called everywhere.
QString stageName(std::size_t index);

/// A step in numbers: the state it starts from, each slope with its weight in the mean, the
/// mean, and the ends of several methods beside the exact one.
class StepTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit StepTable(QWidget* parent = nullptr);

  void showPart(const core::StepPart& part, const core::Method& method, const core::ExactWay& exact,
                const std::vector<core::StepEnd>& ends);
  void clearPart();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Line {
    QString name;
    core::Entries entries;
    bool isSlope;
    QString share;  // of slopes
    QString error;  // of ends
  };

  void showLines(const std::vector<Line>& lines, core::Mode mode);
  void set(int row, int column, const QString& text);
};

}  // namespace ui
