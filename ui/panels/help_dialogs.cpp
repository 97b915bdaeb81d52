#include "ui/panels/help_dialogs.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QVBoxLayout>

#include "ui/control/commands.h"
#include "ui/control/version.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::HelpDialogs)
};

struct Line {
  QString keys;
  QString meaning;
};

std::vector<Line> keyLines(const Commands& commands) {
  std::vector<Line> lines;
  for (const QAction* action : commands.all()) {
    if (action->shortcut().isEmpty()) continue;
    lines.push_back({action->shortcut().toString(QKeySequence::NativeText),
                     action->text().remove('&').remove(QStringLiteral("…"))});
  }
  return lines;
}

std::vector<Line> mouseLines() {
  return {{Words::tr("Wheel"), Words::tr("Zoom")},
          {Words::tr("Drag"), Words::tr("Move the view")},
          {Words::tr("Click on a weight"), Words::tr("Select it")},
          {Words::tr("Drag a weight"), Words::tr("Set its angle or place")},
          {Words::tr("Shift+drag a weight"), Words::tr("Set the length of its rope")},
          {Words::tr("Drag a weight's arrow"), Words::tr("Set its velocity")},
          {Words::tr("Ctrl while dragging"), Words::tr("Snap")},
          {Words::tr("Double click"), Words::tr("Fit the room")},
          {Words::tr("Drag in a chart"), Words::tr("Zoom to a box")},
          {Words::tr("Shift+drag in a chart"), Words::tr("Move what it shows")},
          {Words::tr("+, −, 0 in a chart"), Words::tr("Zoom in, out, show all")},
          {Words::tr("Alt+arrows in a chart"), Words::tr("Move what it shows")},
          {Words::tr("Insert, Delete in the table"), Words::tr("Add, remove weights")},
          {Words::tr("Ctrl+C, Ctrl+V in the table"), Words::tr("Copy, paste cells")},
          {Words::tr("Ctrl+D in the table"), Words::tr("Fill down")},
          {Words::tr("Return in a field"), Words::tr("Apply the value")},
          {Words::tr("Escape in a field"), Words::tr("Bring back the last value")}};
}

/// In two columns of lines, so that all fit on a small screen.
QWidget* table(const std::vector<Line>& lines) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(2);
  grid->setColumnMinimumWidth(2, 16);
  const int half = (static_cast<int>(lines.size()) + 1) / 2;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    const int column = i < half ? 0 : 3;
    auto* keys = new QLabel("<b>" + lines[i].keys.toHtmlEscaped() + "</b>");
    grid->addWidget(keys, i % half, column);
    grid->addWidget(new QLabel(lines[i].meaning), i % half, column + 1);
  }
  return widget;
}

}  // namespace

void showKeys(const Commands& commands, QWidget* window) {
  QDialog dialog(window);
  dialog.setWindowTitle(Words::tr("Keys"));
  auto* layout = new QVBoxLayout(&dialog);
  std::vector<Line> lines = keyLines(commands);
  for (const Line& line : mouseLines()) lines.push_back(line);
  layout->addWidget(table(lines));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  layout->addWidget(buttons);
  dialog.exec();
}

void showAbout(QWidget* window) {
  QMessageBox::about(
      window, Words::tr("About Angry Cuts"),
      Words::tr("<h3>Angry Cuts %1</h3>"
                "<p>Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce "
                "and come to rest. Two numerical methods compute the same scene side by side, and "
                "an energy ledger shows what each of them gets wrong.</p>"
                "<p>Free software under the GNU General Public License, version 3 or later.</p>")
          .arg(version()));
}

}  // namespace ui
