#pragma once

class QCoreApplication;

namespace ui {

/// Makes all texts of the program appear in the user's language, or in English where there
/// is no translation (English needs one for its plurals).
void installTranslations(QCoreApplication& application);

}  // namespace ui
