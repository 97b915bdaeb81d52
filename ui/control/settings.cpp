#include "ui/control/settings.h"

#include <array>

#include "ui/chart/chart_export.h"
#include "ui/control/chart_size_dialog.h"

namespace ui {
namespace {

const QString kPainterKey = QStringLiteral("painter");
const QString kThemeKey = QStringLiteral("theme");
const QString kChartSizeKey = QStringLiteral("chartSize");
const QString kPanelsKey = QStringLiteral("panels");
const QString kHiddenLessonKey = QStringLiteral("hiddenLesson");

// In the order of the enumerations.
const std::array kPainterWords{"automatic", "opengl", "qpainter"};
const std::array kThemeWords{"desktop", "light", "dark"};

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

Settings::Settings() : m_store("angrycuts", "angrycuts") {}

PainterChoice Settings::painter() const {
  return choiceIn<PainterChoice>(m_store, kPainterKey, kPainterWords);
}

void Settings::setPainter(PainterChoice choice) {
  m_store.setValue(kPainterKey, kPainterWords[static_cast<std::size_t>(choice)]);
}

ThemeChoice Settings::theme() const {
  return choiceIn<ThemeChoice>(m_store, kThemeKey, kThemeWords);
}

void Settings::setTheme(ThemeChoice choice) {
  m_store.setValue(kThemeKey, kThemeWords[static_cast<std::size_t>(choice)]);
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

QString Settings::hiddenLesson() const {
  return m_store.value(kHiddenLessonKey).toString();
}

void Settings::setHiddenLesson(const QString& name) {
  m_store.setValue(kHiddenLessonKey, name);
}

}  // namespace ui
