#pragma once

#include <string>

#include <QString>

#include "ui/files/output_file.h"

namespace app {

/// One CSV file, or standard output, that rows stream into.
class CsvOutput {
 public:
  /// @param file    "-": standard output; empty: nothing is wanted
  /// @param header  first line, with its end
  CsvOutput(QString file, std::string_view header);

  bool isWanted() const { return !m_file.isEmpty(); }
  /// Where to append rows.
  std::string& rows() { return m_rows; }

  // Each returns false where it failed and says why in error(); all do nothing where
  // nothing is wanted.
  bool open();
  /// Call now and then: hands on what has gathered.
  bool flush();
  bool finish();

  /// One line that names the file; empty if nothing failed.
  QString error() const;

 private:
  QString m_file;
  std::string m_rows;
  ui::OutputFile m_output;
};

}  // namespace app
