#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

namespace tests {

/// All that is in a file that must be there.
inline QByteArray contentOf(const QString& name) {
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(name));
  return file.readAll();
}

}  // namespace tests
