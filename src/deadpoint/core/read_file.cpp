#include "deadpoint/core/read_file.hpp"

#include "deadpoint/core/error.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace deadpoint {

std::optional<std::string> read_file(const std::filesystem::path& path, std::uintmax_t largest)
{
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return std::nullopt;
    }
    const auto fail = [&] {
        throw IoError(
            fmt::format("cannot read '{}'\n  help: check that it is a file and that you may read it", path.string()));
    };
    if (!std::filesystem::is_regular_file(path, error)) {
        fail();
    }
    if (std::filesystem::file_size(path, error) > largest) {
        throw InputError(fmt::format("{}: the file is larger than {} MiB, the most that is read\n  help: check that "
                                     "it is the file that is meant",
                                     path.string(), largest >> 20U));
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) {
        fail();
    }
    return std::move(text).str();
}

}  // namespace deadpoint
