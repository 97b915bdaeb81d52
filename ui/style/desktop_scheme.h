#pragma once

#include <QObject>

class QDBusVariant;

namespace ui {

/// Knows whether the desktop is dark, and tells when that changes.
///
/// Asks the desktop's settings portal (org.freedesktop.appearance) where there is one; until
/// it answers, and elsewhere, the palette the program started with decides.
class DesktopScheme : public QObject {
  Q_OBJECT

 public:
  explicit DesktopScheme(QObject* parent = nullptr);

  bool isDark() const { return m_dark; }

 signals:
  void darkChanged(bool dark);

 private slots:
  void takeSetting(const QString& group, const QString& key, const QDBusVariant& value);

 private:
  void askPortal();
  void setPreference(uint preference);

  bool m_dark;
};

}  // namespace ui
