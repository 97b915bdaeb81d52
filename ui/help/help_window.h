#pragma once

#include <memory>

#include <QByteArray>
#include <QDialog>
#include <QString>

class QListWidget;
class QTabBar;
class QTextBrowser;
class QTextDocument;

namespace ui {

struct PageLook;

/// A book of three chapters beside the main window, which stays usable: a quick guide, the model
/// with its equations, and the teacher's sheets. What is open can be printed, black on white.
class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  enum class Chapter { kGuide, kModel, kSheets };

  /// Where the reader is; the same in every language.
  struct Place {
    QByteArray geometry;  ///< as saveGeometry() gives it
    Chapter chapter;
    int row;  ///< of the contents
  };

  explicit HelpWindow(QWidget* parent = nullptr);

  /// Shows the window with that chapter open, in front of others.
  void bringUp(Chapter chapter);
  /// Shows the sheet of that lesson.
  void bringUpSheet(const QString& lesson);

  Place place() const;
  /// Shows the window with that place open.
  void bringUp(const Place& place);

  /// The pages that are open, as they are printed.
  std::unique_ptr<QTextDocument> pagesForPaper() const;

  QTextBrowser* page() const { return m_page; }
  QListWidget* contents() const { return m_contents; }

 signals:
  /// What was done, in words.
  void said(const QString& words);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  Chapter chapter() const;
  QWidget* buttons();
  void showChapter();
  void listContents(const QTextDocument& text);
  std::unique_ptr<QTextDocument> text(const PageLook& look) const;
  std::unique_ptr<QTextDocument> textOnScreen() const;
  void showText(std::unique_ptr<QTextDocument> text);
  void goTo(int row);
  QString title() const;
  void print();
  void savePdf();

  QTabBar* m_chapters;
  QListWidget* m_contents;
  QTextBrowser* m_page;
  QString m_lesson;  // whose sheet is shown
};

}  // namespace ui
