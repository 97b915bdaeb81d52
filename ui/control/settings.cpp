#include "ui/control/settings.h"

#include <array>

#include <QCoreApplication>
#include <QDir>

#include "ui/chart/chart_export.h"
#include "ui/control/chart_size_dialog.h"
#include "ui/files/file_lock.h"

namespace ui {
namespace {

const QString kPainterKey = QStringLiteral("painter");
const QString kLanguageKey = QStringLiteral("language");
const QString kThemeKey = QStringLiteral("theme");
const QString kTextSizeKey = QStringLiteral("textSize");
const QString kChartSizeKey = QStringLiteral("chartSize");
const QString kPanelsKey = QStringLiteral("panels");
const QString kHiddenLessonKey = QStringLiteral("hiddenLesson");
const QString kGeometryKey = QStringLiteral("geometry");
const QString kSpeedKey = QStringLiteral("speed");
const QString kChartKindKey = QStringLiteral("chartKind");
const QString kSwitchGroup = QStringLiteral("switches/");
const QString kRecentFilesKey = QStringLiteral("recentFiles");
const QString kLastSceneKey = QStringLiteral("lastScene");

constexpr double kFastest = 1024;  // no button goes so far; a file might

// In the order of the enumerations.
const std::array kPainterWords{"automatic", "opengl", "qpainter"};
const std::array kLanguageWords{"desktop", "en", "sv", "de", "fr", "es"};
const std::array kThemeWords{"desktop", "light", "dark"};
const std::array kTextSizeWords{"normal", "large", "very-large"};

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::Settings)
};

template <class Choice, std::size_t kCount>
Choice choiceIn(const QSettings& store, const QString& key,
                const std::array<const char*, kCount>& words) {
  const QString stored = store.value(key).toString();
  for (std::size_t i = 0; i < kCount; ++i) {
    if (stored == QLatin1String(words[i])) return static_cast<Choice>(i);
  }
  return static_cast<Choice>(0);
}

}  // namespace

Settings::Settings() : m_store("angrycuts", "angrycuts") {
  freeSettingsOfTheDead(m_store.fileName());
}

QString Settings::trouble() const {
  const QString file = QDir::toNativeSeparators(m_store.fileName());
  if (m_store.status() == QSettings::FormatError) {
    return Words::tr("The settings in %1 were damaged; what could not be read is as at first.")
        .arg(file);
  }
  if (m_store.isWritable()) return {};
  return Words::tr("Settings are not remembered: nothing can be written to %1").arg(file);
}

PainterChoice Settings::painter() const {
  return choiceIn<PainterChoice>(m_store, kPainterKey, kPainterWords);
}

void Settings::setPainter(PainterChoice choice) {
  m_store.setValue(kPainterKey, kPainterWords[static_cast<std::size_t>(choice)]);
}

Language Settings::language() const {
  return choiceIn<Language>(m_store, kLanguageKey, kLanguageWords);
}

void Settings::setLanguage(Language language) {
  m_store.setValue(kLanguageKey, kLanguageWords[static_cast<std::size_t>(language)]);
}

ThemeChoice Settings::theme() const {
  return choiceIn<ThemeChoice>(m_store, kThemeKey, kThemeWords);
}

void Settings::setTheme(ThemeChoice choice) {
  m_store.setValue(kThemeKey, kThemeWords[static_cast<std::size_t>(choice)]);
}

TextSize Settings::textSize() const {
  return choiceIn<TextSize>(m_store, kTextSizeKey, kTextSizeWords);
}

void Settings::setTextSize(TextSize size) {
  m_store.setValue(kTextSizeKey, kTextSizeWords[static_cast<std::size_t>(size)]);
}

QSizeF Settings::chartSize() const {
  const QSizeF stored = m_store.value(kChartSizeKey).toSizeF();
  return isChartSize(stored) ? stored : kUsualChartSize;
}

void Settings::setChartSize(QSizeF size) {
  m_store.setValue(kChartSizeKey, size);
}

QByteArray Settings::panels() const {
  return m_store.value(kPanelsKey).toByteArray();
}

void Settings::setPanels(const QByteArray& panels) {
  m_store.setValue(kPanelsKey, panels);
}

QByteArray Settings::geometry() const {
  return m_store.value(kGeometryKey).toByteArray();
}

void Settings::setGeometry(const QByteArray& geometry) {
  m_store.setValue(kGeometryKey, geometry);
}

double Settings::speed() const {
  const double stored = m_store.value(kSpeedKey).toDouble();
  return 1 / kFastest <= stored && stored <= kFastest ? stored : 1;
}

void Settings::setSpeed(double speed) {
  m_store.setValue(kSpeedKey, speed);
}

QString Settings::chartKind() const {
  return m_store.value(kChartKindKey).toString();
}

void Settings::setChartKind(const QString& id) {
  m_store.setValue(kChartKindKey, id);
}

bool Settings::isOn(const QString& name, bool usually) const {
  const QString stored = m_store.value(kSwitchGroup + name).toString();
  return stored.isEmpty() ? usually : stored == QStringLiteral("true");
}

void Settings::setOn(const QString& name, bool on) {
  m_store.setValue(kSwitchGroup + name, on);
}

QStringList Settings::recentFiles() const {
  return m_store.value(kRecentFilesKey).toStringList();
}

void Settings::setRecentFiles(const QStringList& files) {
  m_store.setValue(kRecentFilesKey, files);
}

QString Settings::lastScene() const {
  return m_store.value(kLastSceneKey).toString();
}

void Settings::setLastScene(const QString& fileOrName) {
  m_store.setValue(kLastSceneKey, fileOrName);
}

QString Settings::hiddenLesson() const {
  return m_store.value(kHiddenLessonKey).toString();
}

void Settings::setHiddenLesson(const QString& name) {
  m_store.setValue(kHiddenLessonKey, name);
}

}  // namespace ui
