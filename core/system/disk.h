#pragma once

#include <string>

namespace core {

/// Brings the list of a folder's files onto the disk: a file's new name outlasts a power cut
/// only once its folder is there, too. Where that cannot be asked for it does nothing.
/// @param folder  as the system's own functions take it
void syncFolder(const std::string& folder);

}  // namespace core
