#pragma once

#include <QDialog>
#include <QStringList>

class QListWidget;
class QListWidgetItem;

namespace ui {

class BackgroundTask;

/// The lessons as a menu of pictures. A click, or arrow keys and Enter, choose one.
///
/// Pictures are drawn beside the window, one after the other, those in sight first, in the
/// colors in force; and they are kept.
class LessonChooser : public QDialog {
  Q_OBJECT

 public:
  explicit LessonChooser(QWidget* parent = nullptr);

  /// Shows the menu, with this lesson marked; empty: the one marked before.
  void bringUp(const QString& current);

  QListWidget* list() const { return m_list; }

 signals:
  /// A lesson is wanted, by its scene's name.
  void chosen(const QString& name);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void addLessons();
  void layOut();
  void forgetPictures();
  void drawNextPicture();
  QListWidgetItem* nextWithoutPicture() const;
  void choose(int row);

  QListWidget* m_list;
  BackgroundTask* m_painter;
  QStringList m_sentences;
  int m_look = 0;  // counts sizes and colors: pictures of an earlier look are void
};

}  // namespace ui
