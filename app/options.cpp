#include "app/options.h"

#include <initializer_list>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QFileInfo>

#include "app/arguments.h"
#include "core/methods/method.h"
#include "core/scene/scene_limits.h"

namespace app {

namespace {

// Under its full name lupdate takes solverOf() for a member of core, and its texts for others'.
using core::Solver;

constexpr core::Range kUntilRange{0, 1e6, "s"};
constexpr core::Range kSampleRange{1e-7, 1e6, "s"};

constexpr QLatin1StringView kHelp("help");
constexpr QLatin1StringView kVersion("version");
constexpr QLatin1StringView kExport("export");
constexpr QLatin1StringView kMethod("method");
constexpr QLatin1StringView kStep("step");
constexpr QLatin1StringView kTolerance("tolerance");
constexpr QLatin1StringView kUntil("until");
constexpr QLatin1StringView kCut("cut");
constexpr QLatin1StringView kSample("sample");
constexpr QLatin1StringView kTrajectory("trajectory");
constexpr QLatin1StringView kEnergy("energy");
constexpr QLatin1StringView kEvents("events");
constexpr QLatin1StringView kChart("chart");
constexpr QLatin1StringView kCsv("csv");

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(app::Options)
};

QString joined(const std::vector<QString>& words) {
  return QStringList(words.begin(), words.end()).join(QStringLiteral(", "));
}

QString methodNames() {
  std::vector<QString> names;
  for (const core::Method& method : core::methods()) {
    names.push_back(QString::fromUtf8(method.id.data(), static_cast<qsizetype>(method.id.size())));
  }
  return joined(names);
}

Solver solverOf(const Arguments& arguments) {
  Solver solver;
  if (arguments.has(kMethod)) solver.method = arguments.text(kMethod).toStdString();
  const core::Method* method = core::findOfferedMethod(solver.method);
  if (!method) {
    Arguments::refuse(
        kMethod,
        Texts::tr("must be one of %1, got \"%2\"").arg(methodNames(), arguments.text(kMethod)));
  }
  const QString name = QString::fromStdString(solver.method);
  solver.step = arguments.number(kStep, core::kStepRange, solver.step);
  solver.tolerance = arguments.number(kTolerance, core::kToleranceRange, solver.tolerance);
  if (method->isAdaptive && arguments.has(kStep)) {
    Arguments::refuse(kStep, Texts::tr("%1 takes a tolerance, not a step").arg(name));
  }
  if (!method->isAdaptive && arguments.has(kTolerance)) {
    Arguments::refuse(kTolerance, Texts::tr("%1 takes a step, not a tolerance").arg(name));
  }
  return solver;
}

std::optional<CutChoice> cutOf(const Arguments& arguments) {
  if (!arguments.has(kCut)) return std::nullopt;
  if (arguments.text(kCut) == QStringLiteral("never")) return CutChoice{};
  return CutChoice{arguments.number(kCut, core::kCutTimeRange, 0)};
}

/// The same for all names of one file.
QString identityOf(const QString& file) {
  if (file == QStringLiteral("-")) return file;
  const QFileInfo info(file);
  const QFileInfo folder(info.absolutePath());
  if (info.exists()) return info.canonicalFilePath();
  return folder.canonicalFilePath() + '/' + info.fileName();
}

/// @param files  each with the option that names it; empty ones are not wanted
void refuseSharedFiles(const QString& scene,
                       std::initializer_list<std::pair<QString, QString>> files) {
  QStringList taken;
  if (QFileInfo(scene).isFile()) taken.append(identityOf(scene));
  for (const auto& [option, file] : files) {
    if (file.isEmpty()) continue;
    const QString identity = identityOf(file);
    if (taken.contains(identity)) {
      Arguments::refuse(option, Texts::tr("%1 is used twice").arg(file));
    }
    taken.append(identity);
  }
}

void refuseUnknownPicture(const QString& file) {
  static const QStringList kEndings{QStringLiteral("png"), QStringLiteral("svg"),
                                    QStringLiteral("pdf")};
  if (file.isEmpty() || kEndings.contains(QFileInfo(file).suffix().toLower())) return;
  Arguments::refuse(kChart, Texts::tr("must end in .png, .svg or .pdf, got \"%1\"").arg(file));
}

QString sceneOf(const Arguments& arguments, const QString& command) {
  const QStringList scenes = arguments.words(1);
  if (scenes.isEmpty()) throw CallRefused{Texts::tr("%1: a scene must be named").arg(command)};
  return scenes.front();
}

Call simulateCall(const QStringList& given) {
  const Arguments arguments(
      given, {kHelp},
      {kMethod, kStep, kTolerance, kUntil, kCut, kSample, kTrajectory, kEnergy, kEvents, kChart});
  if (arguments.has(kHelp)) return HelpCall{};

  SimulateCall call;
  call.scene = sceneOf(arguments, QStringLiteral("simulate"));
  call.solver = solverOf(arguments);
  call.until = arguments.number(kUntil, kUntilRange, call.until);
  call.cut = cutOf(arguments);
  call.sample = arguments.number(kSample, kSampleRange, call.sample);
  call.trajectory = arguments.path(kTrajectory);
  call.energy = arguments.path(kEnergy);
  call.events = arguments.path(kEvents);
  call.chart = arguments.path(kChart);
  refuseUnknownPicture(call.chart);
  refuseSharedFiles(call.scene, {{kTrajectory, call.trajectory},
                                 {kEnergy, call.energy},
                                 {kEvents, call.events},
                                 {kChart, call.chart}});
  return call;
}

Call measureCall(const QStringList& given) {
  const Arguments arguments(given, {kHelp}, {kUntil, kCut, kCsv, kChart});
  if (arguments.has(kHelp)) return HelpCall{};

  MeasureCall call;
  call.scene = sceneOf(arguments, QStringLiteral("measure"));
  call.until = arguments.number(kUntil, kUntilRange, call.until);
  call.cut = cutOf(arguments);
  call.csv = arguments.path(kCsv);
  call.chart = arguments.path(kChart);
  refuseUnknownPicture(call.chart);
  refuseSharedFiles(call.scene, {{kCsv, call.csv}, {kChart, call.chart}});
  return call;
}

Call scenesCall(const QStringList& given) {
  const Arguments arguments(given, {kHelp}, {kExport});
  if (arguments.has(kHelp)) return HelpCall{};
  arguments.words(0);
  return ScenesCall{arguments.path(kExport)};
}

Call windowCall(const QStringList& given) {
  const Arguments arguments(given, {kHelp, kVersion});
  if (arguments.has(kHelp)) return HelpCall{};
  if (arguments.has(kVersion)) return VersionCall{};
  const QStringList scenes = arguments.words(2);
  if (scenes.size() > 1) throw CallRefused{Texts::tr("unknown command \"%1\"").arg(scenes[0])};
  return WindowCall{scenes.value(0)};
}

Call callOf(const QStringList& given) {
  if (given.value(0) == QStringLiteral("simulate")) return simulateCall(given.mid(1));
  if (given.value(0) == QStringLiteral("measure")) return measureCall(given.mid(1));
  if (given.value(0) == QStringLiteral("scenes")) return scenesCall(given.mid(1));
  return windowCall(given);
}

}  // namespace

CallOrError parseCall(const QStringList& arguments) {
  try {
    return {callOf(arguments), {}};
  } catch (const CallRefused& refusal) {
    return {std::nullopt, refusal.line};
  }
}

}  // namespace app
