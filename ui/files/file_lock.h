#pragma once

#include <QString>

class QLockFile;

namespace ui {

// Locks of a process that was killed, or whose computer lost its power. Qt asks a lock who made
// it, and waits, or gives up, where it does not tell or tells of another computer name; but the
// system lets go of what a process has locked when that ends.

/// Locks at once, also where the lock of a process that is gone is in the way.
/// @return  false if a process that lives has it
bool lockNow(QLockFile& lock);

/// Takes away the lock that Qt's settings put beside their file, if nobody alive has it.
/// @param settingsFile  that file
void freeSettingsOfTheDead(const QString& settingsFile);

}  // namespace ui
