#pragma once

#include <QDir>
#include <QStringList>

namespace tests {

/// The languages of the window but English, by their codes.
/// @param folder  of the files angrycuts_<code>.ts, or .qm
inline QStringList translatedLanguages(const QDir& folder) {
  QStringList codes;
  for (const QString& file : folder.entryList({"angrycuts_*.ts", "angrycuts_*.qm"}))
    codes << file.section('_', 1).section('.', 0, 0);
  codes.removeOne("en");
  return codes;
}

}  // namespace tests
