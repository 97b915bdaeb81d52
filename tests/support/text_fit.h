#pragma once

#include <QStringList>

class QWidget;

namespace tests {

/// The texts on a window that have less room than they need: on buttons, labels, tabs, headings,
/// in choosers, lists and menus, each with its widget and by how many pixels it is cut; and pages
/// that are wider than their room. Looks at what is visible, scrolled out of sight included; texts
/// that say themselves that they are shortened are left out.
QStringList cutTextsIn(const QWidget& window);

}  // namespace tests
