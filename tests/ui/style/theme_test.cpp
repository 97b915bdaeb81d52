#include "ui/style/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <QTest>

#include "core/scene/arrangement.h"
#include "ui/chart/stability_grade.h"

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// How an eye sees linear red, green and blue.
struct Eye {
  const char* name;
  Matrix3d sees;
};

Matrix3d matrix(std::array<double, 9> rows) {
  return Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
}

/// Source: G. Machado, M. Oliveira, L. Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009)
/// 1291, Table 1, severity 1.
std::vector<Eye> eyes() {
  return {{"usual", Matrix3d::Identity()},
          {"without red cones", matrix({0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216,
                                        -0.003882, -0.048116, 1.051998})},
          {"without green cones", matrix({0.367322, 0.860646, -0.227968, 0.280085, 0.672501,
                                          0.047413, -0.011820, 0.042940, 0.968881})},
          {"without blue cones", matrix({1.255528, -0.076749, -0.178779, -0.078411, 0.930809,
                                         0.147602, 0.004733, 0.691367, 0.303900})}};
}

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

Vector3d linear(const QColor& color) {
  return {linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
}

/// CIE 1976 L*a*b* under D65.
Vector3d labOf(const QColor& color, const Eye& eye) {
  const Matrix3d toXyz = matrix({0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750,
                                 0.0193339, 0.1191920, 0.9503041});
  const Vector3d seen = (eye.sees * linear(color)).cwiseMax(0).cwiseMin(1);
  const Vector3d xyz = (toXyz * seen).cwiseQuotient(Vector3d(0.95047, 1, 1.08883));
  const Vector3d f =
      xyz.unaryExpr([](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; });
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// About 2 can just be told apart side by side.
double difference(const QColor& a, const QColor& b, const Eye& eye) {
  return (labOf(a, eye) - labOf(b, eye)).norm();
}

/// Of the two that are most alike.
double leastDifference(const std::vector<QColor>& colors, const Eye& eye) {
  double least = 1000;
  for (std::size_t a = 0; a < colors.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      least = std::min(least, difference(colors[a], colors[b], eye));
  return least;
}

std::vector<QColor> energies(const ui::Theme& theme) {
  return {theme.kinetic,     theme.potential,      theme.lostToAir, theme.lostToImpacts,
          theme.lostToRopes, theme.lostToFriction, theme.total,     theme.drift};
}

double contrast(const QColor& a, const QColor& b) {
  const Vector3d weights(0.2126, 0.7152, 0.0722);
  const auto [darker, lighter] = std::minmax({linear(a).dot(weights), linear(b).dot(weights)});
  return (lighter + 0.05) / (darker + 0.05);
}

ui::Theme themeNamed(bool dark) {
  return dark ? ui::Theme::darkTheme() : ui::Theme::light();
}

}  // namespace

class ThemeTest : public QObject {
  Q_OBJECT

 private slots:
  void runsCanBeToldApart_data() { addThemes(); }
  void runsCanBeToldApart();
  void noRunLooksLikeAWeight_data() { addThemes(); }
  void noRunLooksLikeAWeight();
  void runsStandOutFromTheGround_data() { addThemes(); }
  void runsStandOutFromTheGround();
  void energiesCanBeToldApart_data() { addThemes(); }
  void energiesCanBeToldApart();
  void textCanBeRead_data() { addThemes(); }
  void textCanBeRead();
  void energiesStandOutFromTheGround_data() { addThemes(); }
  void energiesStandOutFromTheGround();
  void weightsCanBeToldApart();
  void gradesOfStabilityCanBeToldApart();

 private:
  static void addThemes() {
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }
};

void ThemeTest::runsCanBeToldApart() {
  QFETCH(bool, dark);
  const ui::Theme theme = themeNamed(dark);
  for (const Eye& eye : eyes())
    for (std::size_t a = 0; a < theme.runs.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        QVERIFY2(difference(theme.runs[a], theme.runs[b], eye) >= 20, eye.name);
}

void ThemeTest::noRunLooksLikeAWeight() {
  QFETCH(bool, dark);
  core::Scene scene;
  scene.weights.resize(8);  // then the colors begin again
  for (int i = 0; i < 8; ++i) {
    const core::Color color = core::colorOf(scene, i);
    for (const QColor& run : themeNamed(dark).runs)
      for (const Eye& eye : eyes())
        QVERIFY2(difference(run, QColor(color.red, color.green, color.blue), eye) >= 12, eye.name);
  }
}

void ThemeTest::runsStandOutFromTheGround() {
  QFETCH(bool, dark);
  const ui::Theme theme = themeNamed(dark);
  for (const QColor& run : theme.runs)
    for (const QColor& ground : {theme.background, theme.room})
      QVERIFY(contrast(run, ground) >= 4.5);  // names are written in these colors too
}

void ThemeTest::energiesCanBeToldApart() {
  QFETCH(bool, dark);
  const ui::Theme theme = themeNamed(dark);
  // Thin lines beside each other in a chart, and on a timeline and in a step's slopes.
  for (const Eye& eye : eyes()) QVERIFY2(leastDifference(energies(theme), eye) >= 20, eye.name);
}

void ThemeTest::textCanBeRead() {
  QFETCH(bool, dark);
  const ui::Theme theme = themeNamed(dark);
  for (const QColor& ground : {theme.background, theme.room})
    for (const QColor& text : {theme.text, theme.faintText}) QVERIFY(contrast(text, ground) >= 4.5);
}

void ThemeTest::energiesStandOutFromTheGround() {
  QFETCH(bool, dark);
  const ui::Theme theme = themeNamed(dark);
  for (const QColor& ground : {theme.background, theme.room}) {
    for (const QColor& color : energies(theme)) QVERIFY(contrast(color, ground) >= 3);
    QVERIFY(contrast(theme.drift, ground) >= 4.5);  // words are written in it
  }
}

void ThemeTest::weightsCanBeToldApart() {
  std::vector<QColor> colors;
  for (int i = 0; i < 8; ++i) {
    const core::Color color = core::defaultColor(i);
    colors.emplace_back(color.red, color.green, color.blue);
  }
  // Less than for curves: discs are no thin lines.
  for (const Eye& eye : eyes()) QVERIFY2(leastDifference(colors, eye) >= 15, eye.name);
}

void ThemeTest::gradesOfStabilityCanBeToldApart() {
  std::vector<QColor> colors;
  for (int grade = 0; grade <= static_cast<int>(ui::StabilityGrade::kDiverged); ++grade)
    colors.push_back(ui::colorOf(static_cast<ui::StabilityGrade>(grade)));
  for (const Eye& eye : eyes()) QVERIFY2(leastDifference(colors, eye) >= 20, eye.name);
}

QTEST_MAIN(ThemeTest)
#include "theme_test.moc"
