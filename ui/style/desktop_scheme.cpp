#include "ui/style/desktop_scheme.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QGuiApplication>
#include <QPalette>

#include "ui/style/theme.h"

namespace ui {
namespace {

const QString kService = QStringLiteral("org.freedesktop.portal.Desktop");
const QString kPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString kInterface = QStringLiteral("org.freedesktop.portal.Settings");
const QString kGroup = QStringLiteral("org.freedesktop.appearance");
const QString kKey = QStringLiteral("color-scheme");
constexpr uint kPrefersDark = 1;

/// Read() wraps its answer in a second variant, SettingChanged does not.
uint preferenceIn(QVariant value) {
  while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  return value.toUInt();
}

}  // namespace

DesktopScheme::DesktopScheme(QObject* parent)
    : QObject(parent), m_dark(Theme::of(QGuiApplication::palette()).dark) {
  if (QDBusConnection::sessionBus().isConnected()) askPortal();
}

void DesktopScheme::askPortal() {
  QDBusConnection bus = QDBusConnection::sessionBus();
  bus.connect(kService, kPath, kInterface, QStringLiteral("SettingChanged"), this,
              SLOT(takeSetting(QString, QString, QDBusVariant)));

  QDBusMessage read = QDBusMessage::createMethodCall(kService, kPath, kInterface, "Read");
  read << kGroup << kKey;
  auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(read), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
    const QDBusPendingReply<QDBusVariant> reply = *watcher;
    if (reply.isValid()) setPreference(preferenceIn(reply.value().variant()));
    watcher->deleteLater();
  });
}

void DesktopScheme::takeSetting(const QString& group, const QString& key,
                                const QDBusVariant& value) {
  if (group == kGroup && key == kKey) setPreference(preferenceIn(value.variant()));
}

void DesktopScheme::setPreference(uint preference) {
  const bool dark = preference == kPrefersDark;
  if (dark == m_dark) return;
  m_dark = dark;
  emit darkChanged(dark);
}

}  // namespace ui
