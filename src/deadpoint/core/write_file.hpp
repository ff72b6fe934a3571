#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace deadpoint {

/// Whether a file must outlast a loss of power: its bytes are on the disk before it gets its name.
enum class Durability { usual, synced };

/// Writes a file so that it is either complete or absent: `fill` writes to "<path>.part", which is renamed to `path`
/// at the end and removed on failure. The folder must exist; an existing file is replaced.
///
/// @throws IoError naming the path and the system's reason if the file cannot be opened, written or renamed; whatever
///         `fill` throws
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& fill,
                Durability durability = Durability::usual);

/// The same for a text that is at hand.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Puts a file or the entries of a folder on the disk. @return whether that went well
bool sync_to_disk(const std::filesystem::path& path);

}  // namespace deadpoint
