#pragma once

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

namespace core {
struct Range;
}

namespace app {

/// Thrown while arguments are read: one line that says why the call is refused.
struct CallRefused {
  QString line;
};

/// The arguments of one command. Every function throws CallRefused for what is not allowed.
class Arguments {
  Q_DECLARE_TR_FUNCTIONS(app::Arguments)

 public:
  /// @param flags    names of options without a value
  /// @param options  names of options with a value; none may stand twice
  Arguments(const QStringList& given, const QStringList& flags, const QStringList& options = {});

  /// What is no option, in order: at most so many words.
  QStringList words(qsizetype most) const;

  bool has(const QString& option) const { return m_parser.isSet(option); }
  QString text(const QString& option) const { return m_parser.value(option); }
  /// '.' is the decimal point whatever the locale.
  double number(const QString& option, const core::Range& allowed, double otherwise) const;
  /// A file or folder; empty where the option is not given.
  QString path(const QString& option) const;

  [[noreturn]] static void refuse(const QString& option, const QString& reason);

 private:
  QCommandLineParser m_parser;
};

}  // namespace app
