#include "app/arguments.h"

#include <optional>

#include "core/scene/scene_limits.h"
#include "ui/files/degree_text.h"
#include "ui/files/problem_line.h"

namespace app {

Arguments::Arguments(const QStringList& given, const QStringList& flags,
                     const QStringList& options) {
  for (const QString& flag : flags) m_parser.addOption(QCommandLineOption(flag));
  for (const QString& option : options) {
    m_parser.addOption(QCommandLineOption(option, QString(), QStringLiteral("value")));
  }
  // The parser takes the first argument for the program's name.
  if (!m_parser.parse(QStringList{QString()} + given)) throw CallRefused{m_parser.errorText()};
  for (const QString& option : options) {
    if (m_parser.values(option).size() > 1) refuse(option, tr("stands twice"));
  }
}

void Arguments::refuse(const QString& option, const QString& reason) {
  throw CallRefused{QStringLiteral("--%1: %2").arg(option, reason)};
}

QStringList Arguments::words(qsizetype most) const {
  QStringList words = m_parser.positionalArguments();
  if (words.size() > most) throw CallRefused{tr("unexpected argument \"%1\"").arg(words[most])};
  return words;
}

double Arguments::number(const QString& option, const core::Range& allowed,
                         double otherwise) const {
  if (!has(option)) return otherwise;
  const std::optional<double> number = ui::numberFromText(text(option).toStdString());
  if (!number) refuse(option, tr("must be a number, got \"%1\"").arg(text(option)));
  if (allowed.contains(*number)) return *number;
  throw CallRefused{ui::problemLine({.place = "--" + option.toStdString(),
                                     .kind = core::Problem::Kind::kOutOfRange,
                                     .value = *number,
                                     .allowed = allowed})};
}

QString Arguments::path(const QString& option) const {
  if (has(option) && text(option).isEmpty()) refuse(option, tr("must be a name"));
  return text(option);
}

}  // namespace app
