#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace deadpoint {

/// Whether a file must outlast a loss of power: its bytes are on the disk before it gets its name.
enum class Durability { usual, synced };

/// Whether a file of that name may be lost.
enum class IfThere { replace, refuse };

/// Where a file is written before it gets its name: this and an ending of unique_name().
std::string part_prefix(const std::filesystem::path& path);

/// Writes a file so that it is either complete or absent: `fill` writes to a file "<path>.part-..." of its own, which
/// is renamed to `path` at the end and removed on failure. The folder must exist.
///
/// @throws IoError naming the path and the system's reason if the file cannot be opened, written, synced or renamed, or
///         may not replace what is there; whatever `fill` throws
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& fill,
                Durability durability = Durability::usual, IfThere if_there = IfThere::replace);

/// The same for a text that is at hand.
void write_file(const std::filesystem::path& path, std::string_view text, IfThere if_there = IfThere::replace);

/// Puts a file or the entries of a folder on the disk. @return whether that went well; errno says why not
bool sync_to_disk(const std::filesystem::path& path);

}  // namespace deadpoint
