#include "deadpoint/io/child_process.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/confine.hpp"
#include "deadpoint/io/plain_reason.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace deadpoint {
namespace {

using Clock = std::chrono::steady_clock;

// The first byte of what a child hands over: its bytes follow, or a message.
constexpr char handed_over = 0;
constexpr char foreign_error = 1;
constexpr char out_of_memory = 6;  // an ErrorKind stands for itself in between

std::size_t mapped_memory()
{
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void write_all(int to, const char* data, std::size_t size)
{
    while (size > 0) {
        const auto written = write(to, data, size);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            _exit(1);  // no process reads the pipe any more
        }
        data += written;
        size -= static_cast<std::size_t>(written);
    }
}

void hand_over(int to, char kind, const std::string& bytes)
{
    write_all(to, &kind, 1);
    write_all(to, bytes.data(), bytes.size());
}

void set_limit(int resource, std::uint64_t value)
{
    const rlimit limit{value, value};
    setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

/// A library that calls exit() must not run what this program and its libraries do at their end, such as to write
/// settings: that would be a forbidden call.
void end_at_exit()
{
    std::atexit([] { _exit(1); });  // the last one registered is the first one called
}

[[noreturn]] void be_the_child(int to, const ChildLimits& limits, const std::function<std::string()>& work,
                               Refusal* refusal)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    set_limit(RLIMIT_AS, mapped_memory() + limits.memory);
    set_limit(RLIMIT_CORE, 0);
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
        std::signal(signal, SIG_DFL);
    }
    if (std::freopen("/dev/null", "w", stderr) == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr) {
        _exit(1);
    }
    end_at_exit();
    clearenv();  // the environment may name further files that a library would open
    try {
        confine({limits.file, limits.name, to, refusal});
        hand_over(to, handed_over, work());
    } catch (const Error& error) {
        hand_over(to, static_cast<char>(error.kind()), error.what());
    } catch (const std::bad_alloc&) {
        hand_over(to, out_of_memory, "");
    } catch (const std::exception& error) {
        hand_over(to, foreign_error, plain_reason(error));
    } catch (...) {
        hand_over(to, foreign_error, "an error that the program does not know");
    }
    _exit(0);
}

/// A refusal in memory that a child shares.
Refusal* shared_refusal(const std::string& what)
{
    void* place = mmap(nullptr, sizeof(Refusal), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) {
        throw IoError(fmt::format("{}: no process can be started: {}", what, std::strerror(errno)));
    }
    return new (place) Refusal;
}

class Child {
public:
    Child(const std::string& what, const ChildLimits& limits, const std::function<std::string()>& work)
        : what_(what), limits_(limits), refusal_(shared_refusal(what), [](Refusal* r) { munmap(r, sizeof(Refusal)); })
    {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) {
            throw IoError(fmt::format("{}: no process can be started: {}", what_, std::strerror(errno)));
        }
        std::fflush(nullptr);  // otherwise the child would write the content of the buffers again
        process_ = fork();
        if (process_ < 0) {
            close(ends[0]);
            close(ends[1]);
            throw IoError(fmt::format("{}: no process can be started: {}\n  help: end other programs, or allow more "
                                      "processes",
                                      what_, std::strerror(errno)));
        }
        if (process_ == 0) {
            close(ends[0]);
            be_the_child(ends[1], limits, work, refusal_.get());
        }
        close(ends[1]);
        from_ = ends[0];
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child()
    {
        close(from_);
        if (process_ > 0) {
            kill(process_, SIGKILL);
            (void)wait_for_end();
        }
    }

    /// All data that the child hands over.
    std::string read_all(const std::function<void(double)>& waiting)
    {
        const auto start = Clock::now();
        const auto end =
            start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.seconds));
        std::string bytes;
        std::array<char, 65536> buffer{};
        for (;;) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
            pollfd wanted{from_, POLLIN, 0};
            const int ready = left > 0 ? poll(&wanted, 1, static_cast<int>(std::min<long long>(left, 1000))) : 0;
            if (ready == 0 && left <= 0) {
                throw TimeLimitError(
                    fmt::format("{} took longer than {:.3g} s and was stopped\n  help: simplify the file, or "
                                "mesh it with another program and give the mesh",
                                what_, limits_.seconds));
            }
            if (ready == 0 && waiting) {
                waiting(std::chrono::duration<double>(Clock::now() - start).count());
            }
            if (ready <= 0) {
                continue;
            }
            const auto count = read(from_, buffer.data(), buffer.size());
            if (count < 0 && errno == EINTR) {
                continue;
            }
            if (count <= 0) {
                return bytes;
            }
            bytes.append(buffer.data(), static_cast<std::size_t>(count));
        }
    }

    [[nodiscard]] const Refusal& refusal() const { return *refusal_; }

    int wait_for_end()
    {
        int status = 0;
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return status;
    }

private:
    std::string what_;
    ChildLimits limits_;
    std::unique_ptr<Refusal, void (*)(Refusal*)> refusal_;
    pid_t process_ = -1;
    int from_ = -1;
};

/// Text that may come from a foreign file, without what steers a terminal.
std::string printable(std::string text)
{
    std::ranges::replace_if(
        text, [](unsigned char c) { return (c < ' ' && c != '\n') || c == 127; }, '?');
    return text;
}

/// A refused call is noted by a signal's handler; to start a program or a thread the C library holds all signals back.
constexpr const char* unnoted = "to start a program or a thread";

/// Throws the error of a child that was ended for what it asked.
[[noreturn]] void throw_refused(const std::string& what, const Refusal& refusal)
{
    if (refusal.path[0] != '\0') {
        const std::string path = printable({refusal.path, strnlen(refusal.path, sizeof refusal.path)});
        throw StoppedChild(fmt::format("{} was stopped: it wants to open another file, '{}'\n  help: put all into one "
                                       "file; do not use it if it is not yours and should need no other",
                                       what, path));
    }
    throw StoppedChild(fmt::format("{} was stopped: no reader needs what it asks the system for ({})\n  help: the file "
                                   "may be made to attack; do not use it, or check it with the program that wrote it",
                                   what, refusal.call == Refusal::none ? unnoted : name_of_call(refusal.call)));
}

[[noreturn]] void throw_as(char kind, const std::string& what, const std::string& message, const ChildLimits& limits)
{
    switch (kind) {
    case static_cast<char>(ErrorKind::input):
        throw InputError(message);
    case static_cast<char>(ErrorKind::domain):
        throw DomainError(message);
    case static_cast<char>(ErrorKind::convergence):
        throw ConvergenceError(message);
    case static_cast<char>(ErrorKind::io):
        throw IoError(message);
    case out_of_memory:
        throw InputError(
            fmt::format("{} needs more than {:.1f} GB of memory\n  help: make its cells larger, or simplify "
                        "the file; check the counts in it where it is a mesh",
                        what, 1e-9 * static_cast<double>(limits.memory)));
    default:
        throw ForeignError(
            fmt::format("{} failed: {}\n  help: check the file with the program that wrote it", what, message));
    }
}

}  // namespace

std::string run_in_child(const std::string& what, const ChildLimits& limits, const std::function<std::string()>& work,
                         const std::function<void(double)>& waiting)
{
    Child child(what, limits, work);
    std::string bytes = child.read_all(waiting);
    const int status = child.wait_for_end();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS) {
        throw_refused(what, child.refusal());
    }
    if (WIFSIGNALED(status)) {
        throw ForeignError(fmt::format("{} failed: the reader crashed (signal {}, {})\n  help: check the file with "
                                       "the program that wrote it, or give the part in another format",
                                       what, WTERMSIG(status), strsignal(WTERMSIG(status))));
    }
    if (bytes.empty()) {
        throw ForeignError(fmt::format("{} failed: the reader ended without a result\n  help: check the file with the "
                                       "program that wrote it",
                                       what));
    }
    const char kind = bytes.front();
    bytes.erase(0, 1);
    if (kind != handed_over) {
        throw_as(kind, what, printable(bytes), limits);
    }
    return bytes;
}

std::size_t half_of_memory()
{
    return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) / 2 * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace deadpoint
