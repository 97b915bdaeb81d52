#pragma once

#include <vector>

#include <QPointer>
#include <QWidget>

class QLabel;
class QMainWindow;
class QPushButton;

namespace ui {

/// Whether nobody has seen the tour yet.
bool isTourDue();

/// Five hints, one after the other, that point at parts of the window. It lies over the window
/// until it is gone through or skipped, by Esc or by its button, and needs no mouse.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Shows the first hint. Deletes itself when it is over.
  explicit Tour(QMainWindow* window);

  int hint() const { return m_hint; }
  int hintCount() const { return static_cast<int>(m_hints.size()); }
  /// What the present hint points at, in this widget; empty if that is not on the screen.
  QRect pointedAt() const;
  QWidget* bubble() const { return m_bubble; }

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  struct Hint {
    QPointer<QWidget> target;
    QString title;
    QString words;
  };

  void listHints(QMainWindow* window);
  void buildBubble();
  void show(int hint);
  void placeBubble();
  void end();

  std::vector<Hint> m_hints;
  int m_hint = 0;
  QWidget* m_bubble;
  QLabel* m_title;
  QLabel* m_words;
  QLabel* m_count;
  QPushButton* m_skip;
  QPushButton* m_back;
  QPushButton* m_next;
};

}  // namespace ui
