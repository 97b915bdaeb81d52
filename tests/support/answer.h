#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

namespace tests {

/// Presses a button of the message that is about to appear, and returns what it said.
class Answer {
 public:
  explicit Answer(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, &m_context, [this, button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box) return;
      text = box->text();
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
  }

  QString text;

 private:
  QObject m_context;
};

}  // namespace tests
