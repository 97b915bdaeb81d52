#pragma once

#include <QByteArray>
#include <QByteArrayList>
#include <QList>

namespace tests {

/// A table read from CSV: the first line, and the fields of the others.
struct CsvTable {
  QByteArray header;
  QList<QByteArrayList> rows;

  QByteArrayList column(qsizetype index) const {
    QByteArrayList fields;
    for (const QByteArrayList& row : rows) fields.append(row.value(index));
    return fields;
  }
};

/// Checks that every line ends in CR LF.
inline CsvTable csvTableIn(const QByteArray& csv) {
  CsvTable table;
  QByteArrayList lines = csv.split('\n');
  if (lines.takeLast() != "") qFatal("the last line has no end");
  for (QByteArray& line : lines) {
    if (!line.endsWith('\r')) qFatal("a line does not end in CR LF");
    line.chop(1);
  }
  table.header = lines.takeFirst();
  for (const QByteArray& line : lines) table.rows.append(line.split(','));
  return table;
}

}  // namespace tests
