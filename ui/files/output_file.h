#pragma once

#include <memory>
#include <string_view>

#include <QByteArrayView>
#include <QString>

class QFileDevice;

namespace ui {

/// A file that is written bit by bit and stands there whole or not at all: until finish()
/// everything goes to a temporary file beside it, and an older file of that name stays.
///
/// What is no regular file (a pipe, a device, standard output) is written directly.
class OutputFile {
 public:
  OutputFile();
  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;

  // Each returns false where it failed and says why in error().
  bool open(const QString& file);
  bool openStandardOutput();
  /// Hands the bytes on at once, so that large pieces are quick. Does nothing once
  /// something has failed.
  /// @pre open
  bool write(std::string_view bytes);
  bool finish();

  /// What failed first, in words; empty if nothing did.
  const QString& error() const { return m_error; }

 private:
  bool succeeded(bool success);

  std::unique_ptr<QFileDevice> m_device;
  QString m_error;
};

/// Writes a file whole or not at all.
/// @return empty, or what went wrong in words, without the file's name
QString writeWhole(const QString& file, QByteArrayView bytes);

}  // namespace ui
