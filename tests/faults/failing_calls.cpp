/// Preloaded into the program under test: one of its calls on files below DEADPOINT_FAULT_BELOW fails.
///
/// DEADPOINT_FAULT is "<call>:<number>:<what>", or several with ; between: call is read, write, fsync, rename,
/// renameat2 or unlinkat (of a file or folder in a folder); number counts from 1, 0 means all of them; what is an errno
/// as a number, "kill", or a line of shell that runs before the call goes on. DEADPOINT_FAULT_COUNTS names a file that
/// gets the number of calls of each kind.
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

constexpr std::array names{"read", "write", "fsync", "rename", "renameat2", "unlinkat"};
std::array<std::atomic<int>, names.size()> counts{};
const pid_t program = getpid();

template <class Function>
Function real(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool is_below(const char* path)
{
    const char* below = std::getenv("DEADPOINT_FAULT_BELOW");
    return below != nullptr && std::strncmp(path, below, std::strlen(below)) == 0;
}

bool is_below(int file)
{
    std::array<char, 4096> path{};
    return readlink(("/proc/self/fd/" + std::to_string(file)).c_str(), path.data(), path.size() - 1) > 0 &&
           is_below(path.data());
}

/// Does what a fault says if it is about this call. @return whether the call fails, with errno
bool happens(const std::string& fault, const std::string& call, int count)
{
    const auto name = fault.substr(0, fault.find(':')), rest = fault.substr(name.size() + 1);
    const int wanted = std::stoi(rest);
    if (name != call || (wanted != 0 && wanted != count))
        return false;
    const auto what = rest.substr(rest.find(':') + 1);
    if (what == "kill")
        kill(getpid(), SIGKILL);
    if (what.find_first_not_of("0123456789") != std::string::npos) {
        unsetenv("LD_PRELOAD");
        [[maybe_unused]] const int status = std::system(what.c_str());
        return false;
    }
    errno = std::stoi(what);
    return true;
}

/// Counts a call. @return whether it fails, with errno
bool fails(std::size_t call)
{
    const char* faults = std::getenv("DEADPOINT_FAULT");
    if (getpid() != program)
        return false;
    const int count = ++counts[call];
    std::istringstream all(faults != nullptr ? faults : "");
    for (std::string fault; std::getline(all, fault, ';');)
        if (happens(fault, names[call], count))
            return true;
    return false;
}

__attribute__((destructor)) void write_counts()
{
    const char* file = std::getenv("DEADPOINT_FAULT_COUNTS");
    const bool any = std::any_of(counts.begin(), counts.end(), [](const auto& count) { return count > 0; });
    if (file == nullptr || getpid() != program || !any)  // a helper that MPI starts has none
        return;
    std::FILE* out = std::fopen(file, "w");
    for (std::size_t i = 0; out != nullptr && i < names.size(); ++i)
        std::fprintf(out, "%s %d\n", names[i], counts[i].load());
    if (out != nullptr)
        std::fclose(out);
}

}  // namespace

extern "C" ssize_t read(int file, void* data, size_t size)
{
    static const auto call = real<ssize_t (*)(int, void*, size_t)>("read");
    return is_below(file) && fails(0) ? -1 : call(file, data, size);
}

extern "C" ssize_t write(int file, const void* data, size_t size)
{
    static const auto call = real<ssize_t (*)(int, const void*, size_t)>("write");
    return is_below(file) && fails(1) ? -1 : call(file, data, size);
}

extern "C" ssize_t writev(int file, const iovec* parts, int count)
{
    static const auto call = real<ssize_t (*)(int, const iovec*, int)>("writev");
    return is_below(file) && fails(1) ? -1 : call(file, parts, count);
}

extern "C" int fsync(int file)
{
    static const auto call = real<int (*)(int)>("fsync");
    return is_below(file) && fails(2) ? -1 : call(file);
}

extern "C" int rename(const char* from, const char* to) noexcept
{
    static const auto call = real<int (*)(const char*, const char*)>("rename");
    return is_below(to) && fails(3) ? -1 : call(from, to);
}

extern "C" int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned how) noexcept
{
    static const auto call = real<int (*)(int, const char*, int, const char*, unsigned)>("renameat2");
    return is_below(to) && fails(4) ? -1 : call(from_folder, from, to_folder, to, how);
}

extern "C" int unlinkat(int folder, const char* name, int how) noexcept
{
    static const auto call = real<int (*)(int, const char*, int)>("unlinkat");
    return is_below(folder) && fails(5) ? -1 : call(folder, name, how);
}
