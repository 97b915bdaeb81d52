#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenuBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/scene/arrangement.h"
#include "tests/support/shown_window.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_files.h"
#include "ui/files/lessons.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/lesson_card.h"
#include "ui/panels/lesson_chooser.h"
#include "ui/panels/lesson_panel.h"
#include "ui/style/palette.h"
#include "ui/style/theme.h"

using tests::kProjector;
using ui::Command;
using ui::LessonChooser;

namespace {

// All pictures, by one worker on a busy machine [ms].
constexpr int kPatience = 60'000;

core::Scene ownScene() {
  core::Scene scene = core::withWeightCount(core::Scene(), 1);
  scene.name = "Mine";
  return scene;
}

/// The window on the screen, with a lesson in it.
class LessonsWindow : public tests::ShownWindow {
 public:
  explicit LessonsWindow(const core::Scene& scene = ui::builtInScene("seven-weights"))
      : ShownWindow(scene) {}

  LessonChooser* openMenu() {
    QTest::keyClick(this, Qt::Key_L, Qt::ControlModifier);
    auto* menu = findChild<LessonChooser*>();
    if (!menu || !QTest::qWaitForWindowActive(menu)) qFatal("the menu is not active");
    QApplication::setActiveWindow(menu);  // without a window manager
    return menu;
  }

  bool showsText() const { return findChild<ui::LessonPanel*>()->isVisible(); }

  QStringList text() const {
    QStringList words;
    for (const QLabel* label : findChild<ui::LessonPanel*>()->findChildren<QLabel*>())
      if (label->isVisible()) words.append(label->text());
    return words;
  }

  QString sceneName() const { return QString::fromStdString(controller()->scene().name); }
};

QString titleOf(const char* name) {
  return ui::lessonNamed(name).title;
}

}  // namespace

class LessonsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void opensALessonByKeys();
  void opensALessonByAClickOnItsPicture();
  void aButtonOpensTheMenu();
  void everyCardIsReachedByArrowKeys();
  void everyCardCanBeSeenOnAProjector();
  void drawsEveryPictureInTheColorsInForce();
  void marksTheLessonThatIsOpen();
  void showsWhatToLookForAndToTry();
  void theTextCanBePutAwayAndComesWithTheNextLesson();
  void anOwnSceneHasNoText();
  void aLessonThatIsChangedKeepsItsText();
  void staysAwayAtTheNextStartFromTheSameLessonOnly();

 private:
  QTemporaryDir m_folder;
};

void LessonsWindowTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void LessonsWindowTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
}

void LessonsWindowTest::opensALessonByKeys() {
  LessonsWindow window;
  LessonChooser* menu = window.openMenu();
  QTest::keyClick(menu->list(), Qt::Key_Home);
  QTest::keyClick(menu->list(), Qt::Key_Right);
  QTest::keyClick(menu->list(), Qt::Key_Return);
  QVERIFY(!menu->isVisible());
  QCOMPARE(window.sceneName(), titleOf("two-weights"));
}

void LessonsWindowTest::opensALessonByAClickOnItsPicture() {
  LessonsWindow window;
  LessonChooser* menu = window.openMenu();
  const QListWidgetItem* item = menu->list()->item(2);
  QTest::mouseClick(menu->list()->viewport(), Qt::LeftButton, {},
                    menu->list()->visualItemRect(item).center());
  QVERIFY(!menu->isVisible());
  QCOMPARE(window.sceneName(), titleOf("three-pendulums"));
}

void LessonsWindowTest::aButtonOpensTheMenu() {
  LessonsWindow window;
  for (QToolButton* button : window.menuBar()->cornerWidget()->findChildren<QToolButton*>())
    if (button->defaultAction() == window.commands().action(Command::kLessons))
      QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(window.findChild<LessonChooser*>());
  QVERIFY(window.findChild<LessonChooser*>()->isVisible());
}

void LessonsWindowTest::everyCardIsReachedByArrowKeys() {
  LessonsWindow window;
  QListWidget* list = window.openMenu()->list();
  QTest::keyClick(list, Qt::Key_Home);
  for (int row = 1; row < list->count(); ++row) {
    QTest::keyClick(list, Qt::Key_Right);
    QCOMPARE(list->currentRow(), row);
  }
  QTest::keyClick(list, Qt::Key_Home);
  const int columns = list->viewport()->width() / list->gridSize().width();
  QTest::keyClick(list, Qt::Key_Down);
  QCOMPARE(list->currentRow(), columns);
  QTest::keyClick(list, Qt::Key_Up);
  QCOMPARE(list->currentRow(), 0);
  QTest::keyClick(list, Qt::Key_Up);
  QCOMPARE(list->currentRow(), 0);
  QTest::keyClick(list, Qt::Key_End);
  QTest::keyClick(list, Qt::Key_Down);
  QCOMPARE(list->currentRow(), list->count() - 1);
}

void LessonsWindowTest::everyCardCanBeSeenOnAProjector() {
  LessonsWindow window;
  LessonChooser* menu = window.openMenu();
  menu->resize(kProjector * 0.94);
  QCoreApplication::processEvents();
  QListWidget* list = menu->list();
  QVERIFY(list->count() >= 16);
  for (int row = 0; row < list->count(); ++row) {
    list->scrollToItem(list->item(row));
    const QRect card = list->visualItemRect(list->item(row));
    QVERIFY2(list->viewport()->rect().contains(card), qPrintable(list->item(row)->text()));
    QVERIFY(card.width() >= 200 && card.height() >= 200);
  }
  // Two whole rows at once: none is hidden so that one must hunt for it.
  QVERIFY(list->viewport()->height() >= 2 * list->gridSize().height());
}

void LessonsWindowTest::drawsEveryPictureInTheColorsInForce() {
  LessonsWindow window;
  QListWidget* list = window.openMenu()->list();
  const auto picture = [&](int row) {
    return list->item(row)->data(Qt::DecorationRole).value<QImage>();
  };
  const auto allDrawn = [&](const ui::Theme& theme) {
    for (int row = 0; row < list->count(); ++row)
      if (picture(row).isNull() || picture(row).pixel(0, 0) != theme.background.rgb()) return false;
    return true;
  };
  QTRY_VERIFY_WITH_TIMEOUT(allDrawn(ui::Theme::light()), kPatience);
  QApplication::setPalette(ui::paletteOf(ui::Theme::darkTheme()));
  QTRY_VERIFY_WITH_TIMEOUT(allDrawn(ui::Theme::darkTheme()), kPatience);
  QApplication::setPalette(ui::paletteOf(ui::Theme::light()));
  QTRY_VERIFY_WITH_TIMEOUT(allDrawn(ui::Theme::light()), kPatience);
  for (int row = 0; row < list->count(); ++row) {
    const QSize size = ui::LessonCard::pictureSize(list->gridSize().width());
    QCOMPARE(picture(row).size(), size * list->devicePixelRatioF());
    for (int other = 0; other < row; ++other) QVERIFY(picture(row) != picture(other));
  }
}

void LessonsWindowTest::marksTheLessonThatIsOpen() {
  LessonsWindow window(ui::builtInScene("pile"));
  QCOMPARE(window.openMenu()->list()->currentItem()->text(), titleOf("pile"));
}

void LessonsWindowTest::showsWhatToLookForAndToTry() {
  LessonsWindow window;
  for (const ui::Lesson& lesson : ui::lessons()) {
    window.files()->openBuiltIn(lesson.name);
    QCoreApplication::processEvents();  // new labels are laid out
    QVERIFY(window.showsText());
    const QStringList text = window.text();
    QVERIFY(text.contains(lesson.title) && text.contains(lesson.look));
    for (const QString& words : lesson.tries) QVERIFY2(text.contains(words), qPrintable(words));
  }
}

void LessonsWindowTest::theTextCanBePutAwayAndComesWithTheNextLesson() {
  LessonsWindow window;
  QVERIFY(window.showsText());
  QTest::keyClick(&window, Qt::Key_L);
  QVERIFY(!window.showsText());
  QVERIFY(!window.commands().action(Command::kLessonText)->isChecked());
  QTest::keyClick(&window, Qt::Key_L);
  QVERIFY(window.showsText());
  for (QToolButton* button : window.findChild<ui::LessonPanel*>()->findChildren<QToolButton*>())
    if (button->text() == "Hide") QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(!window.showsText());
  window.files()->openBuiltIn("pile");
  QVERIFY(window.showsText());
  QVERIFY(window.text().contains(titleOf("pile")));
}

void LessonsWindowTest::anOwnSceneHasNoText() {
  LessonsWindow window;
  window.editor()->replace(ownScene());
  QVERIFY(!window.showsText());
  window.files()->openBuiltIn("pile");
  QVERIFY(window.showsText());
  LessonsWindow own(ownScene());
  QVERIFY(!own.showsText());
}

void LessonsWindowTest::aLessonThatIsChangedKeepsItsText() {
  LessonsWindow window;
  window.editor()->change([](core::Scene& draft) { draft.gravity = 1.62; });
  QVERIFY(window.showsText());
  QVERIFY(window.text().contains(titleOf("seven-weights")));
  window.editor()->setSaved();
}

void LessonsWindowTest::staysAwayAtTheNextStartFromTheSameLessonOnly() {
  {
    LessonsWindow window;
    QTest::keyClick(&window, Qt::Key_L);
    window.close();
  }
  QVERIFY(!LessonsWindow().showsText());
  QVERIFY(LessonsWindow(ui::builtInScene("pile")).showsText());
}

QTEST_MAIN(LessonsWindowTest)
#include "lessons_window_test.moc"
