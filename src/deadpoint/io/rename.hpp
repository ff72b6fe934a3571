#pragma once

#include <filesystem>
#include <system_error>

/// Renaming that never replaces an existing file by accident, even in a race.
namespace deadpoint {

/// Renames a file or folder to a name that is not taken. If the file system cannot do this in one
/// step, a file is linked under its new name first, and a folder may take the name of an empty one.
/// @return std::errc::file_exists, or directory_not_empty, if the name is taken; nothing is changed then
std::error_code rename_to_new(const std::filesystem::path& from, const std::filesystem::path& to);

/// Swaps the names of two files or folders in one step.
/// @return std::errc::invalid_argument if the file system cannot do this
std::error_code exchange_names(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace deadpoint
