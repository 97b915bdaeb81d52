#pragma once

#include <QChart>
#include <QChartView>
#include <QEvent>

#include "ui/chart/chart_look.h"

namespace ui {

/// A widget around one of the charts about speed, accuracy and stability: gives the plot the
/// window's colors and type, also when they change.
///
/// @tparam Plot  made from a QChart*, with setLook()
template <class Plot>
class TradeView : public QChartView {
 public:
  explicit TradeView(QWidget* parent = nullptr)
      : QChartView(new QChart, parent), m_plot(new Plot(chart())) {
    setRenderHint(QPainter::Antialiasing);
    setFrameShape(QFrame::NoFrame);
    setMinimumSize(360, 260);
    setFocusPolicy(Qt::NoFocus);  // what a click does the table beside it does with keys
    applyLook();
  }

  Plot* plot() const { return m_plot; }

 protected:
  void changeEvent(QEvent* event) override {
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) applyLook();
  }

 private:
  void applyLook() {
    const Theme theme = Theme::of(palette());
    setBackgroundBrush(theme.background);
    m_plot->setLook(ChartLook::forScreen(theme, font()));
  }

  Plot* m_plot;  // belongs to the chart
};

}  // namespace ui
