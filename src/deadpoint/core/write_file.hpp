#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace deadpoint {

/// Writes a file so that it is either complete or absent: `fill` writes to "<path>.part", which is renamed to `path`
/// at the end and removed on failure. The folder must exist; an existing file is replaced.
///
/// @throws IoError naming the path and the system's reason if the file cannot be opened, written or renamed; whatever
///         `fill` throws
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& fill);

/// The same for a text that is at hand.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace deadpoint
