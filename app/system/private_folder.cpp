#include "system/private_folder.hpp"

#include "deadpoint/error.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

/// Whether a folder takes a file of this size; a file that only has its size, without bytes, would say nothing.
bool has_room(const fs::path& folder, std::size_t size)
{
    const auto file = folder / "room";
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    const bool fits = descriptor >= 0 && posix_fallocate(descriptor, 0, static_cast<off_t>(size)) == 0;
    close(descriptor);
    unlink(file.c_str());
    return fits;
}

/// Empty if it cannot be made, with errno.
fs::path make_in(const std::string& folder, std::size_t room)
{
    auto name = folder + "/deadpoint-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) {
        return {};
    }
    if (has_room(name, room)) {
        return name;
    }
    rmdir(name.c_str());
    errno = ENOSPC;
    return {};
}

}  // namespace

PrivateFolder::PrivateFolder(std::size_t room) : owner_(getpid())
{
    const char* wanted = std::getenv("TMPDIR");
    const std::string first = wanted != nullptr && *wanted != '\0' ? wanted : "/tmp";
    int reason = 0;
    for (const auto& folder : {first, std::string("/tmp"), std::string("/dev/shm")}) {
        path_ = make_in(folder, room);
        if (!path_.empty()) {
            return;
        }
        reason = reason == 0 ? errno : reason;
    }
    throw deadpoint::IoError(
        fmt::format("cannot make a folder for temporary files in '{}': {}\n  help: set TMPDIR to a "
                    "folder that you may write to, on a disk with room",
                    first, std::strerror(reason)));
}

PrivateFolder::~PrivateFolder()
{
    std::error_code ignored;
    if (owner_ == getpid()) {
        fs::remove_all(path_, ignored);
    }
}
