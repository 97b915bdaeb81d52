#include "ui/panels/export_button.h"

#include <utility>

#include <QMenu>

#include "ui/control/file_dialog.h"
#include "ui/panels/export_message.h"
#include "ui/style/icons.h"

namespace ui {

ExportButton::ExportButton(std::function<QString()> suggested, QWidget* parent)
    : QToolButton(parent) {
  setText(tr("Export"));
  setToolTip(tr("Save the chart as a picture or its figures as a table"));
  setIcon(ui::icon("save"));
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(this);
  menu->addAction(ui::icon("chart"), tr("Chart…"), this, [this, suggested] {
    const QString file =
        askWhereToSave(window(), tr("Export chart"), suggested() + ".png", pictureKinds());
    if (!file.isEmpty()) emit chartWanted(file);
  });
  menu->addAction(ui::icon("table"), tr("Table…"), this, [this, suggested = std::move(suggested)] {
    const QString file =
        askWhereToSave(window(), tr("Export table"), suggested() + ".csv", {tr("Table (*.csv)")});
    if (!file.isEmpty()) emit tableWanted(file);
  });
  setMenu(menu);
}

}  // namespace ui
