/// Preloaded into the program under test: after DEADPOINT_DISK_ROOM bytes into regular files the disk is full, or the
/// process dies at once where DEADPOINT_DISK_KILLS is set.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

std::atomic<long long> written{0};

bool refuses(int file, long long size)
{
    static const char* const room = std::getenv("DEADPOINT_DISK_ROOM");
    static const bool kills = std::getenv("DEADPOINT_DISK_KILLS") != nullptr;
    struct stat status {};
    if (room == nullptr || fstat(file, &status) != 0 || !S_ISREG(status.st_mode))
        return false;
    if ((written += size) <= std::atoll(room))
        return false;
    if (kills)
        kill(getpid(), SIGKILL);
    errno = ENOSPC;
    return true;
}

}  // namespace

extern "C" ssize_t write(int file, const void* data, size_t size)
{
    static const auto real = reinterpret_cast<ssize_t (*)(int, const void*, size_t)>(dlsym(RTLD_NEXT, "write"));
    return refuses(file, static_cast<long long>(size)) ? -1 : real(file, data, size);
}

extern "C" ssize_t writev(int file, const iovec* parts, int count)
{
    static const auto real = reinterpret_cast<ssize_t (*)(int, const iovec*, int)>(dlsym(RTLD_NEXT, "writev"));
    long long size = 0;
    for (int i = 0; i < count; ++i)
        size += static_cast<long long>(parts[i].iov_len);
    return refuses(file, size) ? -1 : real(file, parts, count);
}
