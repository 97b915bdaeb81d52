#pragma once

#include <QString>

namespace ui {

/// Of the program, such as "1.2.0"; the project in CMakeLists.txt says which.
QString version();

}  // namespace ui
