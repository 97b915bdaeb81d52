#include "ui/files/output_file.h"

#include <cstdio>

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/system/streams.h"

namespace ui {

namespace {

// A buffer would forget why it could not be emptied.
constexpr QIODevice::OpenMode kMode = QIODevice::WriteOnly | QIODevice::Unbuffered;

/// A temporary file would take the place of a device, not write to it.
bool mustBeWrittenDirectly(const QString& file) {
  const QFileInfo info(file);
  return info.exists() && !info.isFile() && !info.isDir();
}

}  // namespace

OutputFile::OutputFile() = default;
OutputFile::~OutputFile() = default;
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;

bool OutputFile::succeeded(bool success) {
  if (!success && m_error.isEmpty()) m_error = m_device->errorString();
  return success;
}

bool OutputFile::open(const QString& file) {
  if (mustBeWrittenDirectly(file)) {
    m_device = std::make_unique<QFile>(file);
  } else {
    m_device = std::make_unique<QSaveFile>(file);
  }
  return succeeded(m_device->open(kMode));
}

bool OutputFile::openStandardOutput() {
  auto output = std::make_unique<QFile>();
  const bool isOpen = output->open(core::descriptorOf(stdout), kMode);
  m_device = std::move(output);
  return succeeded(isOpen);
}

bool OutputFile::write(std::string_view bytes) {
  // A disk that fills up takes a part without an error; asked for the rest it says why.
  while (!bytes.empty() && m_error.isEmpty()) {
    const qint64 written = m_device->write(bytes.data(), static_cast<qint64>(bytes.size()));
    if (!succeeded(written >= 0)) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return m_error.isEmpty();
}

bool OutputFile::finish() {
  if (!m_error.isEmpty()) return false;
  auto* const file = dynamic_cast<QSaveFile*>(m_device.get());
  return !file || succeeded(file->commit());
}

QString writeWhole(const QString& file, QByteArrayView bytes) {
  const std::string_view content(bytes.data(), static_cast<std::size_t>(bytes.size()));
  OutputFile output;
  output.open(file) && output.write(content) && output.finish();
  return output.error();
}

}  // namespace ui
