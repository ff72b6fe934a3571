#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace deadpoint {

/// The largest result file that is read back [byte]; ours stay below a tenth of it.
inline constexpr std::uintmax_t largest_result = 256U << 20U;

/// The bytes of a file.
/// @param largest  [byte], so that a file that is not what it should be cannot fill the memory
/// @return nothing if there is no such file
/// @throws IoError if it cannot be read, or is a folder
/// @throws InputError if it is larger
std::optional<std::string> read_file(const std::filesystem::path& path, std::uintmax_t largest);

}  // namespace deadpoint
