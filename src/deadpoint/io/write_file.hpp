#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace deadpoint {

/// Synced: a file survives a loss of power, since its bytes are on the disk before it gets its
/// name.
enum class Durability { usual, synced };

/// Behaviour if a file of that name exists.
enum class IfThere { replace, refuse };

/// Prefix of the name under which a file is written before it gets its final name; unique_name()
/// adds an ending.
std::string part_prefix(const std::filesystem::path& path);

/// Writes a file so that it is either complete or absent: `fill` writes to a file "<path>.part-..." of its own, which
/// is renamed to `path` at the end and removed on failure. The folder must exist.
///
/// @throws IoError naming the path and the system's reason if the file cannot be opened, written,
/// synced or renamed, or must not replace an existing file; exceptions of `fill` pass through
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& fill,
                Durability durability = Durability::usual, IfThere if_there = IfThere::replace);

/// The same for an existing text.
void write_file(const std::filesystem::path& path, std::string_view text, IfThere if_there = IfThere::replace);

/// Writes a file or the entries of a folder to the disk. @return true on success; else errno has
/// the reason
bool sync_to_disk(const std::filesystem::path& path);

}  // namespace deadpoint
