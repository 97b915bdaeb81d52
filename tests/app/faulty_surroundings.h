#pragma once

// What tests of a window in faulty surroundings share.

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QStringList>
#include <QTest>
#include <QTimer>

#include "core/scene/arrangement.h"
#include "ui/control/run_controller.h"
#include "ui/main_window.h"

// Linux lets nobody make files there, and says so in these words.
inline const QString kReadOnlyFolder = QStringLiteral("/dev/pts");
inline const QString kReadOnlyWords = QStringLiteral("Permission denied|Read-only file system");

inline core::Scene threeWeights() {
  core::Scene scene = core::withWeightCount(core::Scene(), 3);
  scene.name = "Three";
  scene.solvers = {{.method = "rk4"}};
  return scene;
}

inline QByteArray contentOf(const QString& file) {
  QFile input(file);
  return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray("cannot be read");
}

inline void write(const QString& file, const QByteArray& content) {
  QFile output(file);
  if (!output.open(QIODevice::WriteOnly)) qFatal("no room for the test's files");
  output.write(content);
}

/// Confirms the messages that appear while it lives, and notes what they say.
class Messages {
 public:
  Messages() {
    m_timer.callOnTimeout([this] { confirm(); });
    m_timer.start(0);
  }

  QStringList texts;

 private:
  void confirm() {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box || !box->isVisible()) return;
    texts << box->text();
    box->accept();
  }

  QTimer m_timer;
};

/// The window still plays.
inline void verifyAlive(ui::MainWindow& window) {
  window.controller()->setStopwatch([] { return 0.0; });
  const double before = window.controller()->time();
  window.controller()->play();
  window.controller()->passTime(0.1);
  window.controller()->pause();
  QVERIFY(window.controller()->time() > before);
}
