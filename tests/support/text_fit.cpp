#include "tests/support/text_fit.h"

#include <algorithm>

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStyleOptionTab>
#include <QTabBar>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextEdit>
#include <QToolButton>
#include <QWidget>

#include "tests/support/hidden_panel.h"

namespace tests {
namespace {

constexpr int kRounding = 1;  // px: hints are rounded up, and layouts down

/// Collects what does not fit.
class FitCheck {
 public:
  explicit FitCheck(const QWidget& window) : m_window(window) {}

  QStringList cutTexts() {
    for (const QWidget* widget : m_window.findChildren<QWidget*>())
      if (widget->isVisibleTo(&m_window) && !isBehindATab(widget)) look(*widget);
    return m_cut;
  }

 private:
  void look(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) lookAt(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) lookAt(*button);
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) lookAt(*tabs);
    if (const auto* chooser = qobject_cast<const QComboBox*>(&widget)) lookAt(*chooser);
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) lookAt(*header);
    if (const auto* bar = qobject_cast<const QMenuBar*>(&widget)) lookAt(*bar);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) lookAt(*line);
    if (const auto* list = qobject_cast<const QListWidget*>(&widget)) lookAt(*list);
    if (const auto* page = qobject_cast<const QTextEdit*>(&widget)) lookAt(*page);
  }

  void lookAt(const QLabel& label) {
    if (label.text().isEmpty()) return;
    const QRect room = label.contentsRect();
    if (label.wordWrap()) {
      note(label, label.text(), label.heightForWidth(label.width()) - label.height());
      return;
    }
    QTextDocument rich;
    rich.setDefaultFont(label.font());
    rich.setDocumentMargin(0);
    rich.setHtml(label.text());
    const bool isRich = label.textFormat() == Qt::RichText ||
                        (label.textFormat() == Qt::AutoText && Qt::mightBeRichText(label.text()));
    const QSizeF needed =
        isRich ? rich.size() : QSizeF(label.fontMetrics().size(Qt::TextShowMnemonic, label.text()));
    note(label, label.text(), static_cast<int>(needed.width()) - room.width());
    note(label, label.text(), static_cast<int>(needed.height()) - room.height());
  }

  void lookAt(const QAbstractButton& button) {
    if (button.text().isEmpty()) return;
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) return;
    note(button, button.text(), button.sizeHint().width() - button.width());
  }

  void lookAt(const QTabBar& tabs) {
    const int end = tabs.count() == 0 ? 0 : tabs.tabRect(tabs.count() - 1).right() + 1;
    note(tabs, QStringLiteral("tabs that have to be scrolled"), end - tabs.width());
    const int margins = tabs.style()->pixelMetric(QStyle::PM_TabBarTabHSpace, nullptr, &tabs);
    for (int i = 0; i < tabs.count(); ++i) {
      const int needed =
          tabs.fontMetrics().size(Qt::TextShowMnemonic, tabs.tabText(i)).width() + margins / 2;
      note(tabs, tabs.tabText(i), needed - tabs.tabRect(i).width());
    }
  }

  void lookAt(const QComboBox& chooser) {
    QStyleOptionComboBox option;
    option.initFrom(&chooser);
    option.editable = chooser.isEditable();
    const QRect field = chooser.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                        QStyle::SC_ComboBoxEditField, &chooser);
    // One that leaves its room to others says so.
    if (chooser.sizeAdjustPolicy() == QComboBox::AdjustToMinimumContentsLengthWithIcon) return;
    for (int i = 0; i < chooser.count(); ++i) {
      const int icon = chooser.itemIcon(i).isNull() ? 0 : chooser.iconSize().width() + 4;
      note(chooser, chooser.itemText(i),
           chooser.fontMetrics().horizontalAdvance(chooser.itemText(i)) + icon - field.width());
    }
  }

  void lookAt(const QHeaderView& header) {
    if (!header.model()) return;
    for (int i = 0; i < header.count(); ++i) {
      if (header.isSectionHidden(i)) continue;
      const QString text = header.model()->headerData(i, header.orientation()).toString();
      const QSize needed = header.fontMetrics().size(0, text);
      if (header.orientation() == Qt::Horizontal) {
        note(header, text, needed.width() - header.sectionSize(i));
        note(header, text, needed.height() - header.height());
      } else {
        note(header, text, needed.width() - header.width());
      }
    }
  }

  void lookAt(const QMenuBar& bar) {
    const QWidget* corner = bar.cornerWidget();
    const int room = corner ? corner->x() : bar.width();
    for (const QAction* action : bar.actions()) {
      note(bar, action->text(), bar.actionGeometry(const_cast<QAction*>(action)).right() - room);
      if (action->menu()) lookAt(*action->menu());
    }
  }

  void lookAt(const QMenu& menu) {
    const QSize screen = m_window.screen()->size();
    note(menu, menu.title(), menu.sizeHint().height() - screen.height());
    note(menu, menu.title(), menu.sizeHint().width() - screen.width());
    for (const QAction* action : menu.actions())
      if (action->menu()) lookAt(*action->menu());
  }

  void lookAt(const QLineEdit& line) {
    const QString text = line.text().isEmpty() ? line.placeholderText() : line.text();
    // What is typed may be longer; words of the program may not.
    if (text.contains(QRegularExpression(QStringLiteral("[0-9]")))) return;
    note(line, text, line.fontMetrics().horizontalAdvance(text) - line.contentsRect().width());
  }

  void lookAt(const QListWidget& list) {
    // Pictures wrap what stands below them.
    if (list.viewMode() == QListView::IconMode) return;
    for (int row = 0; row < list.count(); ++row) {
      const QModelIndex index = list.model()->index(row, 0);
      // One that says all where it is pointed at may be shortened.
      if (!list.item(row)->toolTip().isEmpty()) continue;
      note(list, list.item(row)->text(),
           list.sizeHintForIndex(index).width() + 2 * list.spacing() - list.viewport()->width());
    }
  }

  /// A page is read from top to bottom, not from side to side.
  void lookAt(const QTextEdit& page) {
    const double needed = page.document()->size().width();  // lays out all of it
    note(page, page.document()->firstBlock().text(),
         std::max(static_cast<int>(needed) - page.viewport()->width(),
                  page.horizontalScrollBar()->maximum()));
  }

  void note(const QWidget& widget, const QString& text, int missing) {
    if (missing <= kRounding) return;
    const QString name =
        widget.accessibleName().isEmpty() ? widget.objectName() : widget.accessibleName();
    m_cut << QStringLiteral("%1 (%2): “%3” lacks %4 px")
                 .arg(QString::fromLatin1(widget.metaObject()->className()), name,
                      QString(text).replace('\n', ' '))
                 .arg(missing);
  }

  const QWidget& m_window;
  QStringList m_cut;
};

}  // namespace

QStringList cutTextsIn(const QWidget& window) {
  return FitCheck(window).cutTexts();
}

}  // namespace tests
