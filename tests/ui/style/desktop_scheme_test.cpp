// On a session bus of its own, with a desktop's settings portal that the test plays.
#include <QAction>
#include <QDBusConnection>
#include <QDBusVariant>
#include <QLocale>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/support/shown_window.h"
#include "ui/control/run_controller.h"
#include "ui/files/scene_file.h"
#include "ui/main_window.h"
#include "ui/style/theme.h"

namespace {

constexpr uint kNoPreference = 0, kPrefersDark = 1, kPrefersLight = 2;

/// A bus that ends with this.
class SessionBus {
 public:
  SessionBus() {
    m_daemon.start("dbus-daemon", {"--session", "--nofork", "--print-address"});
    if (!m_daemon.waitForStarted() || !m_daemon.waitForReadyRead()) qFatal("dbus-daemon is needed");
    m_address = QString::fromUtf8(m_daemon.readAllStandardOutput()).trimmed();
  }
  ~SessionBus() {
    m_daemon.kill();
    m_daemon.waitForFinished();
  }
  Q_DISABLE_COPY_MOVE(SessionBus)

  QString address() const { return m_address; }

 private:
  QProcess m_daemon;
  QString m_address;
};

}  // namespace

/// The part of a desktop that knows whether it is dark.
class SettingsPortal : public QObject {
  Q_OBJECT
  Q_CLASSINFO("D-Bus Interface", "org.freedesktop.portal.Settings")

 public:
  explicit SettingsPortal(const QString& address)
      : m_bus(QDBusConnection::connectToBus(address, "portal")) {
    m_bus.registerObject("/org/freedesktop/portal/desktop", this,
                         QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllSignals);
    if (!m_bus.registerService("org.freedesktop.portal.Desktop")) qFatal("no portal");
  }
  ~SettingsPortal() override {
    m_bus = QDBusConnection(QString());
    QDBusConnection::disconnectFromBus("portal");
  }
  Q_DISABLE_COPY_MOVE(SettingsPortal)

  /// The user switches the desktop over.
  void choose(uint preference) {
    m_preference = preference;
    emit SettingChanged("org.freedesktop.appearance", "color-scheme",
                        QDBusVariant(QVariant::fromValue(preference)));
  }
  /// Something else of the desktop changes.
  void changeContrast() {
    emit SettingChanged("org.freedesktop.appearance", "contrast",
                        QDBusVariant(QVariant::fromValue(1U)));
  }

 public slots:
  // NOLINTNEXTLINE(readability-identifier-naming): the portal's name
  QDBusVariant Read(const QString&, const QString&) {
    return QDBusVariant(QVariant::fromValue(QDBusVariant(QVariant::fromValue(m_preference))));
  }

 signals:
  // NOLINTNEXTLINE(readability-identifier-naming): likewise
  void SettingChanged(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  QDBusConnection m_bus;
  uint m_preference = kNoPreference;
};

class DesktopSchemeTest : public QObject {
  Q_OBJECT

 public:
  static void initMain();

 private slots:
  void initTestCase();
  void startsAsTheDesktopIs_data();
  void startsAsTheDesktopIs();
  void followsTheDesktopWhileItPlays();
  void theUsersChoiceCountsMore();

 private:
  static const SessionBus& bus();

  QTemporaryDir m_folder;
};

const SessionBus& DesktopSchemeTest::bus() {
  static const SessionBus bus;
  return bus;
}

/// Before the application looks for its bus.
void DesktopSchemeTest::initMain() {
  qputenv("DBUS_SESSION_BUS_ADDRESS", bus().address().toUtf8());
}

void DesktopSchemeTest::initTestCase() {
  QLocale::setDefault(QLocale::c());
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
}

void DesktopSchemeTest::startsAsTheDesktopIs_data() {
  QTest::addColumn<uint>("preference");
  QTest::addColumn<bool>("dark");
  QTest::newRow("dark") << kPrefersDark << true;
  QTest::newRow("light") << kPrefersLight << false;
  QTest::newRow("no preference") << kNoPreference << false;
}

void DesktopSchemeTest::startsAsTheDesktopIs() {
  QFETCH(uint, preference);
  QFETCH(bool, dark);
  SettingsPortal portal(bus().address());
  portal.choose(preference);
  const tests::ShownWindow window(ui::builtInScene("seven-weights"));
  QTRY_COMPARE(ui::Theme::of(window.palette()).dark, dark);
}

void DesktopSchemeTest::followsTheDesktopWhileItPlays() {
  SettingsPortal portal(bus().address());
  tests::ShownWindow window(ui::builtInScene("seven-weights"));
  const auto ground = [&] { return window.grab().toImage().pixelColor(2, 300).lightness(); };
  window.press(Qt::Key_Space);
  for (const bool dark : {true, false, true}) {
    portal.choose(dark ? kPrefersDark : kPrefersLight);
    QTRY_COMPARE(ui::Theme::of(window.palette()).dark, dark);
    QTRY_COMPARE(ground() < 128, dark);
    QVERIFY(window.controller()->isPlaying());
  }
  portal.changeContrast();
  QTest::qWait(20);
  QVERIFY(ui::Theme::of(window.palette()).dark);
}

void DesktopSchemeTest::theUsersChoiceCountsMore() {
  SettingsPortal portal(bus().address());
  const tests::ShownWindow window(ui::builtInScene("seven-weights"));
  const auto choose = [&](const QString& words) {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text().remove('&') == words) return action->trigger();
    qFatal("no such choice");
  };
  choose("Light");
  portal.choose(kPrefersDark);
  portal.changeContrast();
  QTest::qWait(50);
  QVERIFY(!ui::Theme::of(window.palette()).dark);
  choose("Like the desktop");
  QTRY_VERIFY(ui::Theme::of(window.palette()).dark);
}

QTEST_MAIN(DesktopSchemeTest)
#include "desktop_scheme_test.moc"
