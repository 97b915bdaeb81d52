#pragma once

#include <QList>
#include <QStringList>

class QWidget;

namespace tests {

// A window, or a part of one that keeps the keyboard to itself.

/// Widgets of a window, visible and not hidden behind another panel, that are there to be used or
/// to be read off: buttons, fields, choosers, sliders, tabs, tables, charts, the scene.
QList<QWidget*> controlsIn(const QWidget& window);

/// Those of them that have no name for screen readers, or no description of what they are for,
/// which pointing at them shows as well.
QStringList namelessIn(const QWidget& window);

/// Columns of tables whose heading does not say, where one points at it, what stands there.
QStringList unexplainedColumnsIn(const QWidget& window);

/// Where Tab goes, from the first widget until it comes round. Needs the window to be active.
QList<QWidget*> tabChainOf(QWidget& window);

/// Widgets that Tab never comes to, though they take the keyboard.
QStringList missedByTab(QWidget& window);

/// Steps of Tab that lead backwards within a panel: to a line above, or to the left in a line.
QStringList backwardStepsOfTab(QWidget& window);

/// Widgets on the way of Tab that look the same with and without the keyboard.
QStringList focusNotSeenIn(QWidget& window);

/// Labels, buttons, tabs, lists and pages whose words are hard to tell from their ground.
QStringList paleTextsIn(const QWidget& window);

}  // namespace tests
