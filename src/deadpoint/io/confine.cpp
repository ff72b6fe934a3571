#include "deadpoint/io/confine.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <initializer_list>
#include <memory>
#include <seccomp.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include <vector>

namespace deadpoint {
namespace {

// How often the file can be opened: for its format, for its contents, and again.
constexpr std::size_t openings = 16;

// Data for the signal handler, only of this process.
std::array<int, openings> waiting_files{};
std::size_t files_left = 0;
std::array<char, 64> name_of_file{};
Refusal* refused = nullptr;

#if defined(__x86_64__)
constexpr bool known_processor = true;
long argument(const ucontext_t& at, int index)
{
    constexpr std::array<int, 3> registers{REG_RDI, REG_RSI, REG_RDX};
    return at.uc_mcontext.gregs[registers[index]];
}
void answer(ucontext_t& at, long value) { at.uc_mcontext.gregs[REG_RAX] = value; }
#elif defined(__aarch64__)
constexpr bool known_processor = true;
long argument(const ucontext_t& at, int index) { return static_cast<long>(at.uc_mcontext.regs[index]); }
void answer(ucontext_t& at, long value) { at.uc_mcontext.regs[0] = static_cast<unsigned long long>(value); }
#else
constexpr bool known_processor = false;
long argument(const ucontext_t&, int) { return 0; }
void answer(ucontext_t&, long) {}
#endif

bool is_the_file(std::string_view path)
{
    const auto slash = path.find_last_of('/');
    return path.substr(slash == std::string_view::npos ? 0 : slash + 1) == name_of_file.data();
}

/// What libraries look for by themselves, whatever they read: facts of the system, time zones, translations of
/// messages and character sets, and the settings that Open CASCADE seeks in the working folder ("XSTEP.us").
bool is_settings(std::string_view path)
{
    constexpr std::array<std::string_view, 6> system{
        "/proc/", "/sys/", "/etc/localtime", "/usr/share/zoneinfo/", "/usr/share/locale", "/usr/lib/"};
    if (std::ranges::any_of(system, [&](std::string_view place) { return path.starts_with(place); })) {
        return true;
    }
    return path.ends_with(".us") &&
           std::ranges::all_of(path.substr(0, path.size() - 3), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// Ends the process by SIGSYS: a second refused call does, since the signal is held back while its handler runs.
[[noreturn]] void end_refused(int call, const char* path)
{
    refused->call = call;
    if (path != nullptr) {
        std::strncpy(refused->path, path, sizeof refused->path - 1);
    }
    syscall(SYS_kill, getpid(), SIGSYS);
    _exit(1);
}

extern "C" void on_refused_call(int, siginfo_t* info, void* context)
{
    const int call = info->si_syscall;
    auto& at = *static_cast<ucontext_t*>(context);
#ifdef SYS_open
    const bool in_a_folder = call != SYS_open;
#else
    const bool in_a_folder = true;
#endif
    if (in_a_folder && call != SYS_openat) {
        end_refused(call, nullptr);
    }
    const auto* path = reinterpret_cast<const char*>(argument(at, in_a_folder ? 1 : 0));
    const bool only_read = (argument(at, in_a_folder ? 2 : 1) & (O_ACCMODE | O_CREAT | O_TRUNC)) == O_RDONLY;
    if (!only_read || (is_the_file(path) && files_left == 0)) {
        end_refused(call, path);
    }
    if (is_the_file(path)) {
        answer(at, waiting_files[--files_left]);
    } else if (is_settings(path)) {
        answer(at, -ENOENT);
    } else {
        end_refused(call, path);
    }
}

[[noreturn]] void fail_without_filters(int error)
{
    throw IoError(fmt::format("files of others are read only where the kernel can keep their reader from everything "
                              "else (seccomp), which it refused here: {}\n  help: allow seccomp filters, or give the "
                              "part as shapes",
                              std::strerror(error)));
}

/// The rules of the kernel's filter; a call without a rule fails with EPERM.
class Filter {
public:
    Filter() : filter_(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release)
    {
        if (!filter_) {
            fail_without_filters(ENOMEM);
        }
    }
    void add(std::uint32_t action, std::initializer_list<int> calls)
    {
        for (const int call : calls) {
            add(action, call, {});
        }
    }
    /// Adds a rule; it applies if all conditions on the call's arguments hold.
    void add(std::uint32_t action, int call, const std::vector<scmp_arg_cmp>& conditions)
    {
        const int result = seccomp_rule_add_array(filter_.get(), action, call, static_cast<unsigned>(conditions.size()),
                                                  conditions.data());
        // A call that this processor does not have needs no rule.
        if (result != 0 && result != -EDOM && result != -EINVAL) {
            fail_without_filters(-result);
        }
    }
    void load()
    {
        if (const int result = seccomp_load(filter_.get()); result != 0) {
            fail_without_filters(-result);
        }
    }

private:
    std::unique_ptr<void, decltype(&seccomp_release)> filter_;
};

void allow_computing(Filter& filter)
{
    filter.add(SCMP_ACT_ALLOW, {SCMP_SYS(brk),
                                SCMP_SYS(munmap),
                                SCMP_SYS(mremap),
                                SCMP_SYS(madvise),
                                SCMP_SYS(futex),
                                SCMP_SYS(getrusage),
                                SCMP_SYS(times),
                                SCMP_SYS(clock_gettime),
                                SCMP_SYS(clock_getres),
                                SCMP_SYS(gettimeofday),
                                SCMP_SYS(time),
                                SCMP_SYS(nanosleep),
                                SCMP_SYS(getpid),
                                SCMP_SYS(gettid),
                                SCMP_SYS(clock_nanosleep),
                                SCMP_SYS(sched_yield),
                                SCMP_SYS(sysinfo),
                                SCMP_SYS(uname),
                                SCMP_SYS(getrandom),
                                SCMP_SYS(rt_sigprocmask),
                                SCMP_SYS(rt_sigreturn),
                                SCMP_SYS(sigaltstack),
                                SCMP_SYS(restart_syscall),
                                SCMP_SYS(sched_getaffinity),
                                SCMP_SYS(exit),
                                SCMP_SYS(exit_group)});
    for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mprotect)}) {
        filter.add(SCMP_ACT_ALLOW, call, {SCMP_A2_64(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)});
        filter.add(SCMP_ACT_TRAP, call, {SCMP_A2_64(SCMP_CMP_MASKED_EQ, PROT_EXEC, PROT_EXEC)});
    }
    const auto self = static_cast<scmp_datum_t>(getpid());
    filter.add(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), {SCMP_A0_64(SCMP_CMP_EQ, self)});  // abort() needs it
    filter.add(SCMP_ACT_ALLOW, SCMP_SYS(rt_sigaction), {SCMP_A0_64(SCMP_CMP_NE, SIGSYS)});
    filter.add(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), {SCMP_A2_64(SCMP_CMP_EQ, 0)});
}

void allow_open_files(Filter& filter, int to)
{
    filter.add(SCMP_ACT_ALLOW,
               {SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(lseek), SCMP_SYS(fstat), SCMP_SYS(close)});
    filter.add(SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), {SCMP_A3_64(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, AT_EMPTY_PATH)});
    filter.add(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1_64(SCMP_CMP_EQ, F_GETFL)});
    for (const int call : {SCMP_SYS(write), SCMP_SYS(writev)}) {
        for (const int file : {STDOUT_FILENO, STDERR_FILENO, to}) {
            filter.add(SCMP_ACT_ALLOW, call, {SCMP_A0_64(SCMP_CMP_EQ, static_cast<scmp_datum_t>(file))});
        }
    }
}

void find_nothing(Filter& filter)
{
    filter.add(SCMP_ACT_ERRNO(ENOTTY), {SCMP_SYS(ioctl)});
    filter.add(SCMP_ACT_ERRNO(ENOENT),
               {SCMP_SYS(access), SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(stat), SCMP_SYS(lstat),
                SCMP_SYS(statx), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),
                SCMP_SYS(unlink)});  // Gmsh removes a file of its own when it forgets a model
    filter.add(SCMP_ACT_ERRNO(ENOENT), SCMP_SYS(newfstatat), {SCMP_A3_64(SCMP_CMP_MASKED_EQ, AT_EMPTY_PATH, 0)});
}

void stop_at_misdeeds(Filter& filter)
{
    filter.add(SCMP_ACT_TRAP, {SCMP_SYS(open),      SCMP_SYS(openat),     SCMP_SYS(openat2),     SCMP_SYS(creat),
                               SCMP_SYS(execve),    SCMP_SYS(execveat),   SCMP_SYS(fork),        SCMP_SYS(vfork),
                               SCMP_SYS(clone),     SCMP_SYS(clone3),     SCMP_SYS(kill),        SCMP_SYS(tkill),
                               SCMP_SYS(socket),    SCMP_SYS(socketpair), SCMP_SYS(connect),     SCMP_SYS(sendto),
                               SCMP_SYS(sendmsg),   SCMP_SYS(unlinkat),   SCMP_SYS(rename),      SCMP_SYS(renameat),
                               SCMP_SYS(renameat2), SCMP_SYS(mkdir),      SCMP_SYS(mkdirat),     SCMP_SYS(rmdir),
                               SCMP_SYS(link),      SCMP_SYS(linkat),     SCMP_SYS(symlink),     SCMP_SYS(symlinkat),
                               SCMP_SYS(mknod),     SCMP_SYS(mknodat),    SCMP_SYS(truncate),    SCMP_SYS(ftruncate),
                               SCMP_SYS(chmod),     SCMP_SYS(fchmod),     SCMP_SYS(fchmodat),    SCMP_SYS(chown),
                               SCMP_SYS(chdir),     SCMP_SYS(ptrace),     SCMP_SYS(memfd_create)});
}

/// Closes all but standard input, output and error and `kept`.
void close_others(std::vector<int> kept)
{
    std::sort(kept.begin(), kept.end());
    unsigned from = STDERR_FILENO + 1;
    for (const int file : kept) {
        const auto number = static_cast<unsigned>(file);
        if (number > from) {
            close_range(from, number - 1, 0);
        }
        from = std::max(from, number + 1);
    }
    close_range(from, ~0U, 0);
}

int open_to_read(const std::string& path)
{
    // A pipe must not make this wait.
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file < 0) {
        throw IoError(fmt::format("the file '{}' cannot be opened: {}\n  help: check its permissions", path,
                                  std::strerror(errno)));
    }
    return file;
}

void keep_only(const Confinement& confinement)
{
    std::vector<int> kept{confinement.to};
    files_left = confinement.file.empty() ? 0 : openings;
    for (std::size_t i = 0; i < files_left; ++i) {
        waiting_files[i] = open_to_read(confinement.file);
        kept.push_back(waiting_files[i]);
    }
    close_others(kept);
    if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) {
        dup2(nothing, STDIN_FILENO);
        close(nothing);
    }
}

void answer_refused_calls(const Confinement& confinement)
{
    refused = confinement.refusal;
    std::strncpy(name_of_file.data(), confinement.name.c_str(), name_of_file.size() - 1);
    struct sigaction action = {};
    action.sa_sigaction = on_refused_call;
    action.sa_flags = SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    sigaction(SIGSYS, &action, nullptr);
    sigset_t unblocked;
    sigemptyset(&unblocked);
    sigaddset(&unblocked, SIGSYS);
    sigprocmask(SIG_UNBLOCK, &unblocked, nullptr);
}

}  // namespace

void confine(const Confinement& confinement)
{
    if (!known_processor) {
        fail_without_filters(ENOSYS);
    }
    Filter filter;
    allow_computing(filter);
    allow_open_files(filter, confinement.to);
    find_nothing(filter);
    stop_at_misdeeds(filter);
    keep_only(confinement);
    answer_refused_calls(confinement);
    filter.load();
}

std::string name_of_call(int number)
{
    const std::unique_ptr<char, decltype(&std::free)> name(seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number),
                                                           std::free);
    return name ? name.get() : fmt::format("{}", number);
}

}  // namespace deadpoint
