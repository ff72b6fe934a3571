#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace deadpoint {

/// The largest result file that is read back [byte]; real ones stay below a tenth of it.
inline constexpr std::uintmax_t largest_result = 256U << 20U;

/// The bytes of a file, all of them: a file that ends before or after its size, as the system states it, is an error.
/// @param largest [byte], so that a wrong file cannot fill the memory
/// @return nothing if there is no such file
/// @throws IoError if it cannot be read to its end, changes meanwhile, or is not a regular file
/// (the function never waits for a pipe)
/// @throws InputError if it is larger
std::optional<std::string> read_file(const std::filesystem::path& path, std::uintmax_t largest);

/// Passes the bytes of a file on piece by piece, for files of any size.
/// @return the file's size [byte]
/// @throws IoError as read_file(), and if there is no such file
std::uintmax_t read_pieces(const std::filesystem::path& path, const std::function<void(std::string_view)>& take);

}  // namespace deadpoint
