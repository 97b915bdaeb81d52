#pragma once

#include <QString>

namespace app {

/// What `--help` prints: every call and option.
QString helpText();

/// What `--version` prints.
QString versionText();

}  // namespace app
