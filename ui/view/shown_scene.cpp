#include "ui/view/shown_scene.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "core/scene/arrangement.h"

namespace ui {

namespace {

QRgb rgbOf(core::Color color) {
  return qRgb(color.red, color.green, color.blue);
}

QString stepText(double step) {
  const double perSecond = 1 / step;
  const double whole = std::round(perSecond);
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  // A fraction reads better, where it is one: to the digits a person would have typed.
  if (whole > 1 && std::abs(perSecond - whole) < 1e-4 * whole)
    return QStringLiteral("1/%1").arg(locale.toString(whole, 'f', 0));
  return locale.toString(step, 'g', 4);
}

}  // namespace

QString solverText(const core::Run& run) {
  const core::Method& method = run.method();
  const QString name =
      QString::fromUtf8(method.name.data(), static_cast<qsizetype>(method.name.size()));
  if (!method.isOffered) return name;
  if (method.isAdaptive)
    return QCoreApplication::translate("ui::SceneView", "%1, tolerance %2")
        .arg(name, QLocale().toString(run.solver().tolerance, 'g', 4));
  return QCoreApplication::translate("ui::SceneView", "%1, %2 s")
      .arg(name, stepText(run.solver().step));
}

ShownScene shownScene(const std::vector<const core::Run*>& runs) {
  ShownScene shown;
  if (runs.empty()) return shown;
  shown.scene = runs.front()->scene();
  const int count = runs.front()->weightCount();
  shown.colors.reserve(count);
  for (int i = 0; i < count; ++i) shown.colors.push_back(rgbOf(core::colorOf(shown.scene, i)));
  shown.time = runs.front()->time();
  for (const core::Run* run : runs) {
    shown.runs.push_back({solverText(*run), {}});
    for (int i = 0; i < count; ++i) shown.runs.back().weights.push_back(run->weight(i));
  }
  return shown;
}

void readWeights(const std::vector<const core::Run*>& runs, double time, ShownScene& shown) {
  shown.time = time;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    std::vector<core::WeightState>& weights = shown.runs[r].weights;
    weights.resize(runs[r]->weightCount());
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] = runs[r]->weightAt(static_cast<int>(i), time);
  }
}

}  // namespace ui
