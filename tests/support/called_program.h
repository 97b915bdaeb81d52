#pragma once

#include <QFile>
#include <QMap>
#include <QTemporaryDir>

#include "tests/support/outcome.h"

namespace tests {

/// A program as a user calls it, in a folder of its own.
class CalledProgram {
 public:
  explicit CalledProgram(QString program) : m_program(std::move(program)) {}

  QString folder() const { return m_folder.path(); }
  QString path(const QString& name) const { return m_folder.filePath(name); }

  /// @return  the file's whole name
  QString write(const QString& name, const QByteArray& content) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly)) qFatal("no room for the test's files");
    file.write(content);
    return file.fileName();
  }

  /// @param environment  what is to differ from the test's own
  Outcome call(const QStringList& arguments, const QMap<QString, QString>& environment = {}) const {
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    for (auto entry = environment.begin(); entry != environment.end(); ++entry)
      all.insert(entry.key(), entry.value());
    return outcomeOf(m_program, arguments, all, folder());
  }

  /// @param command  of bash, in which the program is $1
  Outcome callInShell(const QString& command) const {
    return outcomeOf("bash", {"-c", command, "bash", m_program},
                     QProcessEnvironment::systemEnvironment(), folder());
  }

 private:
  QString m_program;
  QTemporaryDir m_folder;
};

}  // namespace tests
