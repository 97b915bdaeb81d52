// The window speaks another language, and nothing else of it changes.
#include <vector>

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "tests/support/fingerprint.h"
#include "tests/support/settle.h"
#include "ui/chart/chart_widget.h"
#include "ui/control/commands.h"
#include "ui/control/event_navigator.h"
#include "ui/control/run_controller.h"
#include "ui/control/scene_editor.h"
#include "ui/control/scene_target.h"
#include "ui/control/selection.h"
#include "ui/control/settings.h"
#include "ui/control/target_control.h"
#include "ui/files/draft_file.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/panels/charts_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/quantity_field.h"
#include "ui/view/camera.h"
#include "ui/view/scene_area.h"

using tests::settle;
using ui::Command;
using ui::Language;
using ui::MainWindow;

namespace {

/// Lets this much time pass, whatever the clock on the wall says.
void pass(MainWindow& window, double seconds) {
  window.controller()->setStopwatch([] { return 0.0; });
  window.controller()->passTime(seconds);
}

/// A window in which something has been done.
class UsedWindow : public MainWindow {
 public:
  UsedWindow() : MainWindow(ui::builtInScene("two-weights")) {
    setWindowState(Qt::WindowNoState);
    resize(1280, 720);
    show();
    settle();
  }

  void trigger(Command command) const { commands().action(command)->trigger(); }

  std::vector<double> numbers() const {
    std::vector<double> all{controller()->time(), controller()->recordedUntil()};
    for (const core::Run* run : controller()->runs()) {
      const std::vector<double> print = tests::fingerprint(*run);
      all.insert(all.end(), print.begin(), print.end());
    }
    return all;
  }

  QString menuTitle(int index) const { return menuBar()->actions().at(index)->text().remove('&'); }

  ui::SceneArea* area() const { return findChild<ui::SceneArea*>(); }
};

/// What the line across the window says; empty where there is none.
QString shownMessage(const MainWindow& window) {
  QStringList messages;
  for (const ui::MessageBar* bar : window.findChildren<ui::MessageBar*>())
    if (bar->isVisible()) messages << bar->message();
  return messages.join('\n');
}

QToolButton* buttonOf(const MainWindow& window, const QString& words) {
  for (const ui::MessageBar* bar : window.findChildren<ui::MessageBar*>())
    for (QToolButton* button : bar->findChildren<QToolButton*>())
      if (button->isVisible() && button->text() == words) return button;
  qFatal("no button %s", qPrintable(words));
}

QAction* actionOf(const QMenu* menu, const QString& words) {
  for (QAction* action : menu->actions()) {
    if (action->text().remove('&') == words) return action;
    QAction* below = action->menu() ? actionOf(action->menu(), words) : nullptr;
    if (below) return below;
  }
  return nullptr;
}

}  // namespace

class LanguageWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup() { ui::speak(Language::kEnglish); }
  void isChosenFromTheMenu();
  void comesBackAtTheNextStart();
  void goesOnWhereItWas();
  void goesOnPlaying();
  void undoesInTheNewLanguage();
  void keepsADraftThatCannotRun();
  void keepsTheLayout();
  void keepsWhatIsSwitchedOn();
  void keepsTheView();
  void offersWhatCanBeRecovered();
  void writesNumbersAsItsReadersDo();
  void staysInOnePieceWhenSwitchedOften();

 private:
  QTemporaryDir m_settings;
};

void LanguageWindowTest::initTestCase() {
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
}

void LanguageWindowTest::init() {
  QSettings("angrycuts", "angrycuts").clear();
  ui::speak(Language::kEnglish);
}

void LanguageWindowTest::isChosenFromTheMenu() {
  UsedWindow window;
  QCOMPARE(window.menuTitle(0), QString("File"));
  for (const char* name : {"Svenska", "Deutsch", "Français", "Español", "English"}) {
    QAction* action = actionOf(window.menuBar()->actions().at(3)->menu(), name);
    QVERIFY2(action, name);
    QVERIFY(!action->isChecked());
    action->trigger();
    QTRY_VERIFY(actionOf(window.menuBar()->actions().at(3)->menu(), name)->isChecked());
  }
  actionOf(window.menuBar()->actions().at(3)->menu(), "Svenska")->trigger();
  QTRY_COMPARE(window.menuTitle(0), QString("Arkiv"));
  QVERIFY(window.findChild<QDockWidget*>("charts")->windowTitle() != "Charts");
}

void LanguageWindowTest::comesBackAtTheNextStart() {
  {
    UsedWindow window;
    window.speak(Language::kGerman);
  }
  QCOMPARE(ui::Settings().language(), Language::kGerman);
  QSettings("angrycuts", "angrycuts").setValue("language", "klingon");
  QCOMPARE(ui::Settings().language(), Language::kDesktop);
}

void LanguageWindowTest::goesOnWhereItWas() {
  UsedWindow window;
  window.controller()->play();
  for (int i = 0; i < 48; ++i) pass(window, 1.0 / 60);
  window.trigger(Command::kCut);
  for (int i = 0; i < 24; ++i) pass(window, 1.0 / 60);
  window.controller()->pause();
  window.controller()->showTime(1.0);
  window.selection()->select(1);
  const std::vector<double> before = window.numbers();
  const auto events = window.controller()->recording(0).eventLog().events().size();
  QVERIFY(events > 0);

  window.speak(Language::kFrench);
  settle();
  QVERIFY(window.numbers() == before);
  QCOMPARE(window.controller()->recording(0).eventLog().events().size(), events);
  QCOMPARE(window.selection()->weight(), std::optional(1));
  QVERIFY(!window.controller()->isPlaying());
  QVERIFY(window.area()->isVisible());
  QVERIFY(window.area()->marks().selection.has_value());
  // The widgets are new ones, and know it all.
  const auto labels = window.findChildren<QLabel*>();
  QVERIFY(std::ranges::any_of(
      labels, [](const QLabel* label) { return label->text().startsWith("1,000"); }));
  QVERIFY(!window.commands().action(Command::kCut)->isEnabled());
  QVERIFY(window.commands().action(Command::kStepBack)->isEnabled());
}

void LanguageWindowTest::goesOnPlaying() {
  UsedWindow window;
  window.controller()->play();
  pass(window, 0.2);
  const double before = window.controller()->time();
  window.speak(Language::kSpanish);
  QVERIFY(window.controller()->isPlaying());
  QVERIFY(window.commands().action(Command::kPlay)->text() !=
          QCoreApplication::translate("ui::Commands", "&Play"));
  // By the window's own clock, too.
  QTRY_VERIFY(window.controller()->time() > before);
}

void LanguageWindowTest::undoesInTheNewLanguage() {
  UsedWindow window;
  const core::Scene before = *window.editor()->scene();
  for (ui::QuantityField* field : window.findChildren<ui::QuantityField*>()) {
    if (field->spinBox()->accessibleName() != "Gravity") continue;
    emit field->edited(1.6);
  }
  QCOMPARE(window.editor()->undoWords(), QString("change of gravity"));
  window.speak(Language::kSwedish);
  QVERIFY(window.editor()->isModified());
  QVERIFY(window.isWindowModified());
  QVERIFY(window.editor()->undoWords() != "change of gravity");
  QVERIFY(!window.editor()->undoWords().isEmpty());
  QVERIFY(window.commands().action(Command::kUndo)->text().contains(window.editor()->undoWords()));
  window.trigger(Command::kUndo);
  QVERIFY(*window.editor()->scene() == before);
  QVERIFY(!window.editor()->isModified());
}

void LanguageWindowTest::keepsADraftThatCannotRun() {
  UsedWindow window;
  window.editor()->change([](core::Scene& scene) { scene.gravity = -1; });
  QVERIFY(!window.editor()->problems().empty());
  settle();
  const QString english = shownMessage(window);
  QVERIFY(english.contains("Gravity"));
  window.speak(Language::kGerman);
  settle();
  QVERIFY(!window.editor()->problems().empty());
  const QString german = shownMessage(window);
  QVERIFY2(german.contains("Die Fallbeschleunigung"), qPrintable(german));
}

void LanguageWindowTest::keepsTheLayout() {
  UsedWindow window;
  window.findChild<QDockWidget*>("weights")->raise();
  window.findChild<QDockWidget*>("events")->raise();
  window.findChild<QDockWidget*>("comparison")->close();
  window.resizeDocks({window.findChild<QDockWidget*>("scene")}, {430}, Qt::Horizontal);
  settle();
  const auto layout = [&window] {
    QStringList places;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
      if (!dock->widget()->isVisible()) continue;
      places << QStringLiteral("%1 %2×%3")
                    .arg(dock->objectName())
                    .arg(dock->width())
                    .arg(dock->height());
    }
    places.sort();
    return places;
  };
  const QStringList before = layout();
  const QRect place = window.geometry();
  // The same words: nothing needs another width.
  window.speak(Language::kEnglish);
  settle();
  QCOMPARE(layout(), before);
  QCOMPARE(window.geometry(), place);
  window.speak(Language::kFrench);
  settle();
  QCOMPARE(window.geometry(), place);
  QVERIFY(window.findChild<QDockWidget*>("comparison")->isHidden());
  QVERIFY(window.findChild<QDockWidget*>("weights")->widget()->isVisible());
  QVERIFY(window.findChild<QDockWidget*>("events")->widget()->isVisible());
}

void LanguageWindowTest::keepsWhatIsSwitchedOn() {
  UsedWindow window;
  for (const Command command :
       {Command::kForces, Command::kSplit, Command::kTape, Command::kTarget})
    window.commands().action(command)->setChecked(true);
  window.commands().action(Command::kTrails)->setChecked(false);
  window.target()->target()->setPlace({3.0, 0.25});
  window.charts()->chooseKind(2);
  window.charts()->chooseRun(1);
  window.charts()->chart()->setHidden({{}, {1}});
  window.controller()->setSpeed(0.25);
  const auto tape = window.area()->marks().tools.tape;
  window.speak(Language::kSwedish);
  settle();
  for (const Command command :
       {Command::kForces, Command::kSplit, Command::kTape, Command::kTarget})
    QVERIFY(window.commands().action(command)->isChecked());
  QVERIFY(!window.commands().action(Command::kTrails)->isChecked());
  QVERIFY(window.area()->isSplit());
  QVERIFY(window.area()->marks().arrows.forces);
  QCOMPARE(window.area()->marks().tools.tape->from, tape->from);
  QCOMPARE(window.area()->views().front()->target()->place.center, 3.0);
  QCOMPARE(window.charts()->kind(), 2);
  QCOMPARE(window.charts()->view().run, 1);
  QVERIFY(window.charts()->chart()->plot().hidden().runs.contains(1));
  QCOMPARE(window.controller()->speed(), 0.25);
}

void LanguageWindowTest::keepsTheView() {
  UsedWindow window;
  window.trigger(Command::kZoomIn);
  window.area()->views().front()->panBy({20, 10});
  settle();
  const double scale = window.area()->views().front()->camera().scale();
  window.speak(Language::kEnglish);
  settle();
  QVERIFY(!window.area()->views().front()->isFitted());
  QCOMPARE(window.area()->views().front()->camera().scale(), scale);
}

void LanguageWindowTest::offersWhatCanBeRecovered() {
  const QTemporaryDir folder;
  const QString left = folder.filePath("left.draft");
  core::Scene scene = ui::builtInScene("one-pendulum");
  scene.name = "Left behind";
  scene.gravity = 3;
  QCOMPARE(ui::writeDraftFile(left, {{}, scene, {}}), QString());
  UsedWindow window;
  window.keepDraftsIn(folder.path());
  settle();
  const QString english = shownMessage(window);
  QVERIFY2(english.contains("Left behind") && english.contains("ended before"),
           qPrintable(english));

  window.speak(Language::kGerman);
  settle();
  const QString german = shownMessage(window);
  QVERIFY2(german.contains("Left behind") && german.contains("Das Programm endete"),
           qPrintable(german));
  buttonOf(window, "Wiederherstellen")->click();
  QCOMPARE(window.editor()->scene()->gravity, 3.0);
  QCOMPARE(window.editor()->undoWords(), QString("Wiederherstellung von Änderungen"));
  // Once only: neither in another language, nor at the next start.
  QCOMPARE(shownMessage(window), QString());
  QVERIFY(!QFile::exists(left));
  window.speak(Language::kFrench);
  settle();
  QCOMPARE(shownMessage(window), QString());
}

void LanguageWindowTest::writesNumbersAsItsReadersDo() {
  UsedWindow window;
  const auto texts = [&window] {
    QStringList all;
    for (const ui::QuantityField* field : window.findChildren<ui::QuantityField*>())
      all << field->spinBox()->text();
    return all;
  };
  const auto shows = [&texts](const QString& number) {
    return std::ranges::any_of(texts(),
                               [&](const QString& text) { return text.startsWith(number); });
  };
  QVERIFY(shows("9.81"));
  window.speak(Language::kGerman);
  QVERIFY(shows("9,81"));
}

void LanguageWindowTest::staysInOnePieceWhenSwitchedOften() {
  UsedWindow window;
  const auto kinds = [&window] {
    QMap<QString, int> count;
    // Animations of Qt's own end by themselves.
    for (const QObject* object : window.findChildren<QObject*>())
      if (!object->inherits("QAbstractAnimation")) ++count[object->metaObject()->className()];
    return count;
  };
  window.speak(Language::kSwedish);
  settle();
  const QMap<QString, int> before = kinds();
  for (const Language language : {Language::kGerman, Language::kFrench, Language::kSwedish}) {
    window.speak(language);
    settle();
    window.controller()->stepOnce();
  }
  // Nothing of the old ones is left.
  const QMap<QString, int> after = kinds();
  for (const QString& kind : after.keys()) {
    QVERIFY2(after[kind] <= before.value(kind),
             qPrintable(
                 QString("%1: %2, before %3").arg(kind).arg(after[kind]).arg(before.value(kind))));
  }
}

QTEST_MAIN(LanguageWindowTest)
#include "language_window_test.moc"
