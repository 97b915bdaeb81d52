#include "ui/control/version.h"

namespace ui {

QString version() {
  return QStringLiteral(ANGRYCUTS_VERSION);
}

}  // namespace ui
