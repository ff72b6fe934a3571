#include "deadpoint/io/rename.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace deadpoint {
namespace {

namespace fs = std::filesystem;

std::error_code rename_by(const fs::path& from, const fs::path& to, unsigned how)
{
    if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), how) == 0) {
        return {};
    }
    const int reason = errno == ENOSYS || errno == EOPNOTSUPP ? EINVAL : errno;
    return {reason, std::generic_category()};
}

std::error_code link_and_unlink(const fs::path& from, const fs::path& to)
{
    if (link(from.c_str(), to.c_str()) != 0 || unlink(from.c_str()) != 0) {
        return {errno, std::generic_category()};
    }
    return {};
}

}  // namespace

std::error_code rename_to_new(const fs::path& from, const fs::path& to)
{
    auto error = rename_by(from, to, RENAME_NOREPLACE);
    if (error != std::errc::invalid_argument) {
        return error;
    }
    if (!fs::is_directory(from, error)) {
        return link_and_unlink(from, to);
    }
    fs::rename(from, to, error);  // the kernel refuses files and folders that are not empty
    return error;
}

std::error_code exchange_names(const fs::path& a, const fs::path& b) { return rename_by(a, b, RENAME_EXCHANGE); }

}  // namespace deadpoint
