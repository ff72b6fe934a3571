#include "deadpoint/io/file_lock.hpp"

#include "deadpoint/error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace deadpoint {
namespace {

constexpr std::string_view kind = "deadpoint lock: ";

std::string this_process()
{
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    return fmt::format("process {} on {} since {:%Y-%m-%d %H:%M:%S} UTC", getpid(), host.data(),
                       fmt::gmtime(std::time(nullptr)));
}

/// The beginning of a file.
std::string beginning(int descriptor)
{
    std::array<char, 512> text{};
    const auto size = pread(descriptor, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
}

/// Opens the file of a lock, or makes it. @throws IoError if it is something else
int open_lock(const std::filesystem::path& file)
{
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (descriptor < 0) {
        throw IoError(fmt::format("cannot write '{}': {}\n  help: check that the folder exists and that you may write "
                                  "there",
                                  file.string(), std::strerror(errno)));
    }
    struct stat status {};
    const auto text = beginning(descriptor);
    if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && (text.empty() || text.starts_with(kind))) {
        return descriptor;
    }
    close(descriptor);
    throw IoError(
        fmt::format("'{}' is the name of a lock of deadpoint, but that file is something else\n  help: rename "
                    "the file, or give another folder with -o",
                    file.string()));
}

/// Writes the holder of the lock to the file. Only a message uses it.
void say_who(int descriptor)
{
    const auto text = fmt::format("{}{}\n", kind, this_process());
    [[maybe_unused]] const bool done =
        ftruncate(descriptor, 0) == 0 && pwrite(descriptor, text.data(), text.size(), 0) > 0;
}

[[noreturn]] void refuse(const std::string& what, int descriptor)
{
    auto holder = beginning(descriptor);
    close(descriptor);
    holder = holder.starts_with(kind) ? holder.substr(kind.size(), holder.find('\n') - kind.size()) : "another process";
    throw IoError(
        fmt::format("{} by {}\n  help: wait until it is done, stop it, or name another folder", what, holder));
}

}  // namespace

FileLock::FileLock(std::filesystem::path file, const std::string& what) : file_(std::move(file)), owner_(getpid())
{
    while (!take(what)) {
    }
    say_who(descriptor_);
}

FileLock::~FileLock()
{
    if (owner_ == getpid()) {
        unlink(file_.c_str());
        close(descriptor_);
    }
}

bool FileLock::is_still_there() const
{
    struct stat named {
    }, open{};
    return stat(file_.c_str(), &named) == 0 && fstat(descriptor_, &open) == 0 && named.st_ino == open.st_ino &&
           named.st_dev == open.st_dev;
}

// False if another process removed the file with its lock in between.
bool FileLock::take(const std::string& what)
{
    descriptor_ = open_lock(file_);
    if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
        held_ = is_still_there();
        if (!held_) {
            close(descriptor_);
        }
        return held_;
    }
    if (errno == EWOULDBLOCK) {
        refuse(what, descriptor_);
    }
    return true;
}

}  // namespace deadpoint
