#include <algorithm>
#include <functional>

#include <QAction>
#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFontInfo>
#include <QGraphicsTextItem>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "tests/support/settle.h"
#include "tests/support/shown_window.h"
#include "ui/chart/chart_look.h"
#include "ui/control/commands.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/keys_page.h"
#include "ui/panels/lesson_chooser.h"
#include "ui/view/camera.h"
#include "ui/view/scene_drawing.h"
#include "ui/view/scene_look.h"
#include "ui/view/scene_view.h"
#include "ui/view/shown_scene.h"
#include "ui/view/trails.h"

using tests::kProjector;
using ui::Command;

namespace {

constexpr double kSmallest = 12;  // pt

/// Whether something of it is on the screen: of an area that scrolls that is what is in it.
bool isSeen(const QWidget* widget) {
  return !widget->visibleRegion().isEmpty() ||
         std::ranges::any_of(widget->findChildren<QWidget*>(),
                             [](const QWidget* part) { return !part->visibleRegion().isEmpty(); });
}

class ProjectedWindow : public tests::ShownWindow {
 public:
  ProjectedWindow() : ShownWindow(ui::builtInScene("seven-weights")) {
    controller()->stepOnce();
    QCoreApplication::processEvents();
  }

  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    ShownWindow::press(key, modifiers);
    QCoreApplication::processEvents();
  }

  /// Picks an entry of the view menu by its words.
  void choose(const QString& words) {
    for (QAction* action : findChildren<QAction*>())
      if (action->text().remove('&') == words) action->trigger();
    tests::settle();
  }
};

/// One line for each part whose type is too small.
QStringList smallTypeIn(const QWidget* root, double least = kSmallest) {
  QStringList found;
  const auto check = [&](const QFont& font, const QString& who) {
    // Half a pixel is lost where a size is rounded to whole ones.
    const double points = QFontInfo(font).pointSizeF();
    if (points < least - 0.4) found << QString("%1: %2 pt").arg(who).arg(points);
  };
  QList<const QWidget*> widgets{root};
  for (const QWidget* widget : root->findChildren<QWidget*>()) widgets << widget;
  for (const QWidget* widget : widgets) {
    if (widget->inherits("QTableCornerButton")) continue;  // never says anything
    check(widget->font(),
          QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName()));
    const auto* view = qobject_cast<const QChartView*>(widget);
    if (!view) continue;
    for (const QGraphicsItem* item : view->scene()->items())
      if (const auto* text = dynamic_cast<const QGraphicsTextItem*>(item);
          text && text->isVisible() && !text->toPlainText().isEmpty())
        check(text->font(), "words of a chart");
  }
  return found;
}

/// Letters that lead to an action from the menu bar, or none where one of them is missing.
QString mnemonicPath(const QAction* action) {
  const auto letter = [](const QString& text) {
    const qsizetype mark = text.indexOf('&');
    return mark < 0 ? QString() : text.mid(mark + 1, 1).toLower();
  };
  for (const QObject* object : action->associatedObjects()) {
    const auto* menu = qobject_cast<const QMenu*>(object);
    if (!menu) continue;
    if (letter(action->text()).isEmpty()) return {};
    QString path = letter(action->text());
    for (; menu; menu = qobject_cast<const QMenu*>(menu->parentWidget())) {
      if (letter(menu->title()).isEmpty()) break;
      path.prepend(letter(menu->title()));
      if (qobject_cast<const QMenuBar*>(menu->parentWidget())) return path;
    }
  }
  return {};
}

/// Does this with the dialog that is about to appear, and closes it.
class WhenShown {
 public:
  explicit WhenShown(std::function<void(QWidget*)> look) {
    QTimer::singleShot(0, &m_context, [this, look = std::move(look)] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      m_wasShown = true;
      look(dialog);
      dialog->reject();
    });
  }
  bool wasShown() const { return m_wasShown; }

 private:
  QObject m_context;
  bool m_wasShown = false;
};

}  // namespace

class ProjectorTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void nothingInTheWindowIsUnder12Points();
  void nothingInADialogIsUnder12Points();
  void nothingInTheSceneIsUnder12Points();
  void textSizeIsChosenLiveAndRemembered();
  void textCanShrinkAgain();
  void everyCommandHasAKeyOrLetters();
  void noTwoCommandsShareAKey();
  void tabReachesEveryControlThatIsSeenAndNoOther();
  void allKeysFitOnAProjector();
  void theKeysPageNamesEveryKey();

 private:
  QTemporaryDir m_folder;
};

void ProjectorTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void ProjectorTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
}

void ProjectorTest::nothingInTheWindowIsUnder12Points() {
  ProjectedWindow window;
  for (const char* panel : {"charts", "comparison", "step", "events", "weights", "scene"}) {
    window.findChild<QDockWidget*>(panel)->raise();
    QCoreApplication::processEvents();
    QCOMPARE(smallTypeIn(&window).join('\n'), QString());
  }
}

void ProjectorTest::nothingInADialogIsUnder12Points() {
  ProjectedWindow window;
  for (const Command command : {Command::kKeys, Command::kAbout, Command::kGoTo}) {
    QStringList small;
    WhenShown shown([&](QWidget* dialog) { small = smallTypeIn(dialog); });
    window.commands().action(command)->trigger();
    QVERIFY2(shown.wasShown(), qPrintable(window.commands().action(command)->text()));
    QCOMPARE(small.join('\n'), QString());
  }
  for (const Command command : {Command::kLessons, Command::kMeasure, Command::kWhenToCut})
    window.commands().action(command)->trigger();
  const auto dialogs = window.findChildren<QDialog*>();
  QVERIFY(dialogs.size() >= 3);
  for (const QDialog* dialog : dialogs) QCOMPARE(smallTypeIn(dialog).join('\n'), QString());
}

void ProjectorTest::nothingInTheSceneIsUnder12Points() {
  ProjectedWindow window;
  ui::ShownScene shown = ui::shownScene(window.controller()->runs());
  ui::SceneLook look{ui::Theme::light(), ui::readableFont(window.font())};
  ui::Camera camera;
  camera.setViewport(QSizeF(860, 300));
  camera.fit({5, 3}, ui::sceneMargins(shown, look, 860));
  const ui::Drawing drawing = ui::sceneDrawing(shown, ui::Trails(), camera, look);
  QVERIFY(drawing.texts.size() > 5);
  for (const ui::Text& text : drawing.texts)
    QVERIFY2(QFontInfo(text.font).pixelSize() >= 16, qPrintable(text.words));  // 12 pt at 96 dpi
}

void ProjectorTest::textSizeIsChosenLiveAndRemembered() {
  double large = 0;
  {
    ProjectedWindow window;
    const QImage usual = window.findChild<ui::SceneView*>()->grab().toImage();
    window.choose("Very large");
    large = QApplication::font().pointSizeF();
    QVERIFY(large > kSmallest);
    QCOMPARE(smallTypeIn(&window, large).join('\n'), QString());
    const ui::SceneView* scene = window.findChild<ui::SceneView*>();
    QVERIFY(window.findChild<ui::SceneView*>()->grab().toImage() != usual);
    QCOMPARE(scene->font().pointSizeF(), large);
    window.close();
  }
  ProjectedWindow again;
  QCOMPARE(QApplication::font().pointSizeF(), large);
  QCOMPARE(smallTypeIn(&again, large).join('\n'), QString());
}

void ProjectorTest::textCanShrinkAgain() {
  ProjectedWindow window;
  tests::settle();
  const QSize least = window.minimumSizeHint();
  window.choose("Very large");
  QVERIFY(window.minimumSizeHint() != least);
  window.choose("Normal");
  QCOMPARE(QApplication::font().pointSizeF(), kSmallest);
  QTRY_COMPARE(window.minimumSizeHint(), least);
}

void ProjectorTest::everyCommandHasAKeyOrLetters() {
  const ProjectedWindow window;
  for (const QAction* action : window.commands().all())
    QVERIFY2(!action->shortcut().isEmpty() || !mnemonicPath(action).isEmpty(),
             qPrintable(action->text()));
}

void ProjectorTest::noTwoCommandsShareAKey() {
  const ProjectedWindow window;
  QHash<QString, QString> owners;
  for (const QAction* action : window.commands().all()) {
    if (!action->isEnabled()) continue;  // Esc serves what is under way
    for (const QKeySequence& keys : action->shortcuts()) {
      const QString name = keys.toString();
      QVERIFY2(!owners.contains(name), qPrintable(name + ' ' + owners.value(name)));
      owners.insert(name, action->text());
    }
  }
}

void ProjectorTest::tabReachesEveryControlThatIsSeenAndNoOther() {
  ProjectedWindow window;
  QSet<const QWidget*> reached;
  QWidget* first = nullptr;
  for (int i = 0; i < 400; ++i) {
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window,
                    Qt::Key_Tab);
    QWidget* focus = QApplication::focusWidget();
    QVERIFY(focus);
    if (focus == first) break;
    if (!first) first = focus;
    // Nobody can see what is typed into a panel behind another one.
    QVERIFY2(isSeen(focus), qPrintable(focus->metaObject()->className() + focus->accessibleName()));
    reached.insert(focus);
  }
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    // Behind another panel it is reached when that is in front.
    if (!widget->isVisible() || !widget->isEnabled() || widget->visibleRegion().isEmpty()) continue;
    const bool isControl = widget->inherits("QAbstractButton") ||
                           widget->inherits("QAbstractSpinBox") || widget->inherits("QComboBox") ||
                           widget->inherits("QAbstractSlider") || widget->inherits("QTabBar") ||
                           widget->inherits("QAbstractItemView");
    const QString name = widget->objectName();
    // Parts of others: arrows of tabs, scroll bars, corners of tables.
    if (!isControl || widget->inherits("QScrollBar") || widget->inherits("QTabBar") ||
        qobject_cast<QTabBar*>(widget->parentWidget()) || widget->inherits("QTableCornerButton") ||
        widget->inherits("QHeaderView") || name.startsWith("qt_"))
      continue;
    const auto* button = qobject_cast<const QToolButton*>(widget);
    const bool hasKey =
        button && button->defaultAction() && !button->defaultAction()->shortcut().isEmpty();
    const bool isReached = reached.contains(widget) || reached.contains(widget->focusProxy());
    QVERIFY2(hasKey || isReached,
             qPrintable(QString("%1 %2 %3")
                            .arg(widget->metaObject()->className(), name,
                                 widget->accessibleName() + widget->toolTip())));
  }
}

void ProjectorTest::allKeysFitOnAProjector() {
  const ProjectedWindow window;
  constexpr int kForTitleAndButton = 110;  // px, with margins
  const ui::KeysPage page(window.commands(), static_cast<int>(kProjector.height() * 0.84));
  const QSize needed = page.sizeHint() + QSize(40, kForTitleAndButton);
  QVERIFY2(needed.boundedTo(kProjector) == needed,
           qPrintable(QString("%1 × %2").arg(needed.width()).arg(needed.height())));
}

void ProjectorTest::theKeysPageNamesEveryKey() {
  const ProjectedWindow window;
  const ui::KeysPage page(window.commands(), 500);
  QStringList words;
  for (const QLabel* label : page.findChildren<QLabel*>()) words << label->text().split(", ");
  for (const QAction* action : window.commands().all()) {
    QString keys = action->shortcut().toString(QKeySequence::NativeText);
    // One line for the arrow keys with Alt, one for those with Alt and Shift.
    if (keys.startsWith("Alt+")) keys = keys.section('+', 0, -2) + "+arrows";
    QVERIFY2(keys.isEmpty() || words.contains(keys), qPrintable(keys));
  }
  for (const char* group : {"File", "Edit", "Run", "Go to", "View", "Chart", "In the scene"})
    QCOMPARE(words.count(group), 1);
}

QTEST_MAIN(ProjectorTest)
#include "projector_test.moc"
