#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace ui {

/// A line across the window that says what went wrong, with a button or two to do something
/// about it. Hidden while there is nothing to say.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  /// @param offer        words on the button; empty: no button
  /// @param otherOffer   words on a second one
  explicit MessageBar(const QString& offer = {}, const QString& otherOffer = {},
                      QWidget* parent = nullptr);

  /// Says it, or hides the bar if there is nothing to say.
  void say(const QString& message);
  QString message() const;

 signals:
  /// The button was pressed.
  void accepted();
  /// The second button was pressed.
  void otherAccepted();

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QLabel* m_icon;
  QLabel* m_text;
  QToolButton* m_button;
  QToolButton* m_otherButton;
};

}  // namespace ui
