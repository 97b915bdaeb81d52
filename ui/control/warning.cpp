#include "ui/control/warning.h"

#include <QMessageBox>

namespace ui {

void warn(QWidget* window, const QString& title, const QString& words) {
  QMessageBox box(QMessageBox::Warning, title, words, QMessageBox::Ok, window);
  box.setTextFormat(Qt::PlainText);
  box.exec();
}

}  // namespace ui
