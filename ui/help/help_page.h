#pragma once

#include <QTextBrowser>

namespace ui {

/// A page of text to read, with a frame around it while it has the keyboard.
class HelpPage : public QTextBrowser {
  Q_OBJECT

 public:
  explicit HelpPage(QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;

 private:
  void paintFrame();
};

}  // namespace ui
