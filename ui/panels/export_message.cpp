#include "ui/panels/export_message.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "ui/control/warning.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::Exports)
};

}  // namespace

QStringList pictureKinds() {
  return {Words::tr("PNG picture (*.png)"), Words::tr("SVG drawing (*.svg)"),
          Words::tr("PDF document (*.pdf)")};
}

void sayIfNotExported(QWidget* window, const QString& file, const QString& error) {
  if (error.isEmpty()) return;
  warn(window, Words::tr("Not exported"),
       Words::tr("%1 was not written:\n%2").arg(QFileInfo(file).fileName(), error));
}

}  // namespace ui
