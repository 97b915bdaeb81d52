#include "ui/control/file_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QRegularExpression>

namespace ui {
namespace {

/// "png" in "PNG picture (*.png)"; of several the first.
QString endingOf(const QString& kind) {
  static const QRegularExpression kPattern(R"(\*\.([\w.]+))");
  return kPattern.match(kind).captured(1);
}

}  // namespace

QString askWhereToSave(QWidget* window, const QString& title, const QString& suggestedFile,
                       const QStringList& kinds) {
  QFileDialog dialog(window, title);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(kinds);
  dialog.setDefaultSuffix(endingOf(kinds.first()));
  dialog.selectFile(suggestedFile);
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                   [&dialog](const QString& kind) { dialog.setDefaultSuffix(endingOf(kind)); });
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString fileNameFrom(const QString& words) {
  static const QRegularExpression kOther(R"([^\w-]+)",
                                         QRegularExpression::UseUnicodePropertiesOption);
  QString name = words.trimmed().toLower();
  name.replace(kOther, QStringLiteral("-"));
  return name.isEmpty() ? QCoreApplication::translate("ui::FileDialog", "scene") : name;
}

}  // namespace ui
