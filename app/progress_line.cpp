#include "app/progress_line.h"

#include <cstdio>

#include <QCoreApplication>

#include "core/system/streams.h"

namespace app {

ProgressLine::ProgressLine() : m_isShown(core::isTerminal(stderr)) {}

ProgressLine::~ProgressLine() {
  if (m_percent >= 0) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::show(double share) {
  const int percent = static_cast<int>(100 * share);
  if (!m_isShown || percent == m_percent) return;
  m_percent = percent;
  const QString words = QCoreApplication::translate("app::ProgressLine", "Measuring: %1 %");
  std::fprintf(stderr, "\r%s", words.arg(percent).toUtf8().constData());
}

}  // namespace app
