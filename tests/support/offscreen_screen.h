#pragma once

#include <QFile>
#include <QSize>
#include <QTemporaryDir>

namespace tests {

/// Lets the application that is about to start find one screen of this size [logical px].
/// @pre there is no application yet: to be called in initMain()
inline void useScreen(QSize size) {
  static const QTemporaryDir folder;
  QFile screens(folder.filePath("screens.json"));
  if (!screens.open(QIODevice::WriteOnly)) qFatal("no screen");
  // As the platform of tests wants to be told what screens there are.
  screens.write(QStringLiteral(R"({"screens": [{"name": "only", "x": 0, "y": 0, "width": %1,
      "height": %2, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})")
                    .arg(size.width())
                    .arg(size.height())
                    .toUtf8());
  qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + screens.fileName().toUtf8());
}

}  // namespace tests
