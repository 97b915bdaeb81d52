#include "ui/files/long_text.h"

#include <QDir>
#include <QFile>
#include <QLocale>

namespace ui {
namespace {

const QString kEnglish = QStringLiteral("en");

}  // namespace

QStringList languagesOf(const QString& kind) {
  return QDir(QStringLiteral(":/") + kind).entryList(QDir::Dirs, QDir::Name);
}

QString longText(const QString& kind, const QString& name, const QString& language) {
  QFile file(QStringLiteral(":/%1/%2/%3.md").arg(kind, language, name));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString longText(const QString& kind, const QString& name) {
  const QString language = QLocale().name().section('_', 0, 0);
  const QString text = longText(kind, name, language);
  return text.isEmpty() ? longText(kind, name, kEnglish) : text;
}

}  // namespace ui
