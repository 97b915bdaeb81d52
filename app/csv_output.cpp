#include "app/csv_output.h"

#include <utility>

#include <QCoreApplication>

namespace app {

namespace {

constexpr std::size_t kLargePiece = std::size_t{1} << 16;
constexpr QLatin1StringView kStandardOutput("-");

}  // namespace

CsvOutput::CsvOutput(QString file, std::string_view header)
    : m_file(std::move(file)), m_rows(header) {}

bool CsvOutput::open() {
  if (!isWanted()) return true;
  return m_file == kStandardOutput ? m_output.openStandardOutput() : m_output.open(m_file);
}

bool CsvOutput::flush() {
  if (m_rows.size() < kLargePiece) return true;
  const bool isWritten = m_output.write(m_rows);
  m_rows.clear();
  return isWritten;
}

bool CsvOutput::finish() {
  return !isWanted() || (m_output.write(m_rows) && m_output.finish());
}

QString CsvOutput::error() const {
  if (m_output.error().isEmpty()) return {};
  const QString name = m_file == kStandardOutput
                           ? QCoreApplication::translate("app::CsvOutput", "standard output")
                           : m_file;
  return name + QStringLiteral(": ") + m_output.error();
}

}  // namespace app
