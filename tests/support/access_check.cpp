#include "tests/support/access_check.h"

#include <algorithm>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QHash>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextEdit>
#include <QToolButton>
#include <QWidget>

#include "tests/support/contrast.h"
#include "tests/support/hidden_panel.h"

namespace tests {
namespace {

constexpr int kMostSteps = 500;  // of Tab, before it should have come round

/// Qt's own parts of a widget are named with it.
bool isPartOfAnother(const QWidget* widget) {
  const QWidget* parent = widget->parentWidget();
  if (qobject_cast<const QLineEdit*>(widget))
    return qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent);
  if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget))
    return true;
  if (qobject_cast<const QAbstractButton*>(widget))
    return qobject_cast<const QTabBar*>(parent) || qobject_cast<const QTableView*>(parent) ||
           widget->inherits("QDockWidgetTitleButton") || widget->inherits("QToolBarExtension") ||
           widget->inherits("QMenuBarExtension");
  for (const QWidget* above = parent; above; above = above->parentWidget())
    if (qobject_cast<const QComboBox*>(above)) return true;
  return false;
}

bool isDrawing(const QWidget* widget) {
  static const QStringList kDrawings{
      "ui::ChartWidget", "ui::SceneView",     "ui::Timeline",          "ui::SeparationChart",
      "ui::StepPlot",    "ui::CutSweepChart", "ui::WorkPrecisionPlot", "ui::StabilityPlot"};
  return widget->inherits("QChartView") ||
         kDrawings.contains(QString::fromLatin1(widget->metaObject()->className()));
}

/// Over drawings and texts a tip would hide what it explains.
bool isLookedAt(const QWidget* widget) {
  return isDrawing(widget) || qobject_cast<const QTextEdit*>(widget);
}

bool isControl(const QWidget* widget) {
  if (widget->inherits("QToolBarSeparator")) return false;
  return qobject_cast<const QAbstractButton*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTabBar*>(widget) ||
         qobject_cast<const QAbstractItemView*>(widget) || isDrawing(widget) ||
         ((widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy());
}

QString described(const QWidget* widget) {
  const QWidget* panel = widget;
  while (panel->parentWidget() && !qobject_cast<const QDockWidget*>(panel) && !panel->isWindow())
    panel = panel->parentWidget();
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  const QString name = !widget->accessibleName().isEmpty() ? widget->accessibleName()
                       : button                            ? button->text()
                                                           : widget->objectName();
  return QStringLiteral("%1 “%2” in %3")
      .arg(QString::fromLatin1(widget->metaObject()->className()), name,
           panel->objectName().isEmpty() ? panel->windowTitle() : panel->objectName());
}

/// The panel that a widget belongs to, within which the order is judged.
const QWidget* panelOf(const QWidget* widget) {
  while (widget->parentWidget() && !widget->isWindow()) {
    if (qobject_cast<const QDockWidget*>(widget)) return widget;
    const QWidget* parent = widget->parentWidget();
    if (parent->isWindow()) return widget;
    widget = parent;
  }
  return widget;
}

QRect placeOf(const QWidget* widget) {
  return {widget->mapTo(widget->window(), QPoint(0, 0)), widget->size()};
}

bool takesTab(const QWidget* widget) {
  return widget->isVisible() && widget->isEnabled() &&
         (widget->focusPolicy() & Qt::TabFocus) != 0 && !widget->focusProxy();
}

}  // namespace

QList<QWidget*> controlsIn(const QWidget& window) {
  QList<QWidget*> controls;
  for (QWidget* widget : window.findChildren<QWidget*>())
    if (widget->window() == window.window() && widget->isVisible() && !isBehindATab(widget) &&
        isControl(widget) && !isPartOfAnother(widget))
      controls << widget;
  return controls;
}

QStringList namelessIn(const QWidget& window) {
  QStringList nameless;
  for (QWidget* widget : controlsIn(window)) {
    const QAccessibleInterface* face = QAccessible::queryAccessibleInterface(widget);
    if (!face) {
      nameless << described(widget) + ": unknown to screen readers";
      continue;
    }
    if (face->text(QAccessible::Name).isEmpty()) nameless << described(widget) + ": no name";
    // What a button in a dialog does it says itself.
    const bool isPlainButton = qobject_cast<QPushButton*>(widget) && window.inherits("QDialog");
    // Qt's tabs keep theirs to themselves.
    const QString description = qobject_cast<QTabBar*>(widget)
                                    ? widget->accessibleDescription()
                                    : face->text(QAccessible::Description);
    if (description.isEmpty() && !isPlainButton) nameless << described(widget) + ": no description";
    const bool hasTip =
        !widget->toolTip().isEmpty() || qobject_cast<QTabBar*>(widget) || isLookedAt(widget);
    if (!hasTip && !isPlainButton) nameless << described(widget) + ": no tip";
  }
  return nameless;
}

QStringList unexplainedColumnsIn(const QWidget& window) {
  QStringList unexplained;
  for (const QTableView* table : window.findChildren<QTableView*>()) {
    if (!table->isVisibleTo(&window) || !table->model()) continue;
    for (int i = 0; i < table->model()->columnCount(); ++i)
      if (table->model()->headerData(i, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty())
        unexplained << described(table) + ": " +
                           table->model()->headerData(i, Qt::Horizontal).toString();
  }
  return unexplained;
}

QList<QWidget*> tabChainOf(QWidget& window) {
  QList<QWidget*> chain;
  if (QWidget* focus = QApplication::focusWidget()) focus->clearFocus();
  for (int i = 0; i < kMostSteps; ++i) {
    QWidget* from = QApplication::focusWidget();
    QTest::keyClick(from ? from : &window, Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    if (!now || chain.contains(now)) break;
    chain << now;
  }
  // It goes on from where the keyboard was last; what comes first is the window's affair.
  const QWidget* first = &window;
  while (!chain.isEmpty() && !chain.contains(first)) first = first->nextInFocusChain();
  const auto start = std::ranges::find(chain, first);
  std::rotate(chain.begin(), start, chain.end());
  return chain;
}

QStringList missedByTab(QWidget& window) {
  // Before: work in the background may show more meanwhile.
  const QList<QWidget*> controls = controlsIn(window);
  const QList<QWidget*> chain = tabChainOf(window);
  QStringList missed;
  for (QWidget* widget : controls)
    if (takesTab(widget) && !chain.contains(widget)) missed << described(widget);
  if (chain.isEmpty()) missed << QStringLiteral("everything");
  return missed;
}

QStringList backwardStepsOfTab(QWidget& window) {
  QStringList backward;
  QHash<const QWidget*, QWidget*> last;  // of each panel
  for (QWidget* widget : tabChainOf(window)) {
    const QWidget* panel = panelOf(widget);
    if (QWidget* before = last.value(panel)) {
      const QRect from = placeOf(before);
      const QRect to = placeOf(widget);
      const bool isAbove = to.bottom() <= from.top();
      const bool isInLine = to.top() < from.bottom() && from.top() < to.bottom();
      if (isAbove || (isInLine && to.right() <= from.left()))
        backward << described(before) + " → " + described(widget);
    }
    last[panel] = widget;
  }
  return backward;
}

namespace {

/// A table without rows has no place that the keyboard could be at; and a button of a dialog that
/// Return presses from anywhere looks as if it had the keyboard at all times.
bool showsNoFocus(const QWidget* widget) {
  const auto* view = qobject_cast<const QAbstractItemView*>(widget);
  const bool isEmpty = view && (!view->model() || view->model()->rowCount() == 0);
  const auto* button = qobject_cast<const QPushButton*>(widget);
  return isEmpty || (button && button->autoDefault());
}

}  // namespace

QStringList focusNotSeenIn(QWidget& window) {
  QStringList unseen;
  for (QWidget* widget : tabChainOf(window)) {
    if (showsNoFocus(widget)) continue;
    widget->setFocus(Qt::TabFocusReason);
    const QImage with = widget->grab().toImage();
    widget->clearFocus();
    const QImage without = widget->grab().toImage();
    if (with == without) unseen << described(widget);
  }
  return unseen;
}

namespace {

constexpr double kLeastContrast = 4.5;  // of texts, in the Guidelines' level AA

bool showsWords(const QWidget* widget) {
  const auto* label = qobject_cast<const QLabel*>(widget);
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  const auto* list = qobject_cast<const QListWidget*>(widget);
  const auto* tabs = qobject_cast<const QTabBar*>(widget);
  return (label && !label->text().isEmpty()) || (button && !button->text().isEmpty()) ||
         (list && list->count() > 0) || (tabs && tabs->count() > 0);
}

/// The strongest contrast that a picture has with most of it.
double strongestContrast(const QImage& image) {
  QHash<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  QRgb ground = 0;
  for (auto color = counts.begin(); color != counts.end(); ++color)
    if (color.value() > counts.value(ground)) ground = color.key();
  double strongest = 1;
  for (auto color = counts.begin(); color != counts.end(); ++color)
    strongest = std::max(strongest, contrast(color.key(), ground));
  return strongest;
}

/// The weakest that a letter of the page has with its ground.
double weakestContrast(const QTextEdit& page) {
  const QColor ground = page.palette().color(QPalette::Base);
  double weakest = contrast(page.palette().color(QPalette::Text), ground);
  for (QTextBlock block = page.document()->begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); part != block.end(); ++part) {
      const QTextCharFormat format = part.fragment().charFormat();
      if (format.hasProperty(QTextFormat::ForegroundBrush))
        weakest = std::min(weakest, contrast(format.foreground().color(), ground));
    }
  }
  return weakest;
}

}  // namespace

QStringList paleTextsIn(const QWidget& window) {
  QStringList pale;
  const auto note = [&pale](const QWidget* widget, double contrast) {
    if (contrast < kLeastContrast)
      pale << QStringLiteral("%1: contrast %2").arg(described(widget)).arg(contrast, 0, 'f', 2);
  };
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool isSeen = widget->window() == window.window() && widget->isVisible() &&
                        widget->isEnabled() && !isBehindATab(widget);
    if (!isSeen || widget->visibleRegion().isEmpty()) continue;
    if (const auto* page = qobject_cast<const QTextEdit*>(widget))
      note(page, weakestContrast(*page));
    if (showsWords(widget)) note(widget, strongestContrast(widget->grab().toImage()));
  }
  return pale;
}

}  // namespace tests
