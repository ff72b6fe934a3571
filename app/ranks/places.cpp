#include "ranks/places.hpp"

#include "deadpoint/error.hpp"
#include "ranks/launcher.hpp"
#include "system/private_folder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <poll.h>
#include <random>
#include <string_view>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto longest_start = 30s;
constexpr auto longest_end = 3s;
constexpr int not_started = 127;
constexpr std::size_t largest_environment = std::size_t{4} << 20;
constexpr std::size_t room_of_mpi = std::size_t{16} << 20;  // Open MPI's shared files among temporary ones [byte]

/// A name that no file has: Linux keeps it while the socket is open.
struct Address {
    explicit Address(std::string_view name)
    {
        address.sun_family = AF_UNIX;
        std::copy_n(name.data(), std::min(name.size(), sizeof address.sun_path - 1), address.sun_path + 1);
        size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    }
    [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address); }

    sockaddr_un address{};
    socklen_t size = 0;
};

/// True for a peer that the same user runs; another one could name itself as a holder.
bool is_ours(int socket)
{
    ucred peer{};
    socklen_t size = sizeof peer;
    return getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == geteuid();
}

/// False where the kernel forbids to read another process's memory (some containers). Open MPI would fail on it.
bool memory_can_be_read()
{
    char from = 1, to = 0;
    const iovec source{&from, 1}, target{&to, 1};
    return process_vm_readv(getpid(), &target, 1, &source, 1, 0) == 1;
}

std::string own_program()
{
    std::array<char, 4096> path{};
    const auto size = readlink("/proc/self/exe", path.data(), path.size());
    return size > 0 ? std::string(path.data(), static_cast<std::size_t>(size)) : std::string();
}

/// The one that belongs to the MPI of this program, or another that the user names.
std::string mpirun_program()
{
    if (const char* wanted = std::getenv("DEADPOINT_MPIRUN")) {
        return wanted;
    }
    return access(DEADPOINT_MPIRUN, X_OK) == 0 ? DEADPOINT_MPIRUN : "mpirun";
}

/// Environment of mpirun: ranks of any user, on this machine, more than cores if wanted, bound to no core (a second run
/// beside this one would be bound to the same).
std::vector<std::string> mpirun_environment(const std::string& folder)
{
    auto result = environment_of_no_launcher();
    std::erase_if(result, [](const std::string& variable) { return variable.starts_with("TMPDIR="); });
    result.push_back("TMPDIR=" + folder);
    for (const char* setting :
         {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "OMPI_MCA_rmaps_base_oversubscribe=1",
          "OMPI_MCA_hwloc_base_binding_policy=none", "PRTE_ALLOW_RUN_AS_ROOT=1", "PRTE_ALLOW_RUN_AS_ROOT_CONFIRM=1",
          "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe", "PRTE_MCA_hwloc_default_binding_policy=none"}) {
        result.emplace_back(setting);
    }
    if (!memory_can_be_read()) {
        result.emplace_back("OMPI_MCA_btl_vader_single_copy_mechanism=none");
    }
    return result;
}

[[noreturn]] void become_mpirun(const std::string& program, int count, const std::string& socket, int log,
                                const std::string& folder)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    setpgid(0, 0);  // Ctrl-C goes to the program, not to mpirun
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGUSR1, SIGXFSZ}) {
        std::signal(signal, SIG_DFL);
    }
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    auto environment = mpirun_environment(folder);
    std::vector<std::string> arguments{program, "-n", std::to_string(count), own_program(), hold_place_argument,
                                       socket};
    std::vector<char*> argv, envp;
    for (auto& text : arguments) {
        argv.push_back(text.data());
    }
    for (auto& text : environment) {
        envp.push_back(text.data());
    }
    argv.push_back(nullptr);
    envp.push_back(nullptr);
    execvpe(program.c_str(), argv.data(), envp.data());
    const auto reason = fmt::format("cannot start {}: {}\n", program, std::strerror(errno));
    [[maybe_unused]] const auto written = write(STDERR_FILENO, reason.data(), reason.size());
    _exit(not_started);
}

/// Whether a process has ended, and how.
bool ended(pid_t process, int* status = nullptr) { return waitpid(process, status, WNOHANG) != 0; }

bool wait_for_end(pid_t process, Clock::duration longest)
{
    for (const auto start = Clock::now(); Clock::now() - start < longest;) {
        if (ended(process)) {
            return true;
        }
        std::this_thread::sleep_for(2ms);
    }
    return false;
}

/// All that a holder sends, two zeros at its end. Empty if it sends anything else.
std::string read_environment(int socket)
{
    std::string text;
    std::array<char, 65536> buffer{};
    while (!text.ends_with(std::string_view("\0\0", 2))) {
        pollfd wanted{socket, POLLIN, 0};
        if (poll(&wanted, 1, 5000) <= 0) {
            return {};
        }
        const auto count = read(socket, buffer.data(), buffer.size());
        if (count <= 0 || text.size() > largest_environment) {
            return {};
        }
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
}

}  // namespace

Places::Places(int count) : owner_(getpid()), log_(memfd_create("mpirun", MFD_CLOEXEC))
{
    const auto name = fmt::format("deadpoint-{}-{:x}", owner_, std::random_device{}());
    const Address address(name);
    const int listener = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (listener < 0 || bind(listener, address.get(), address.size) != 0 || listen(listener, count) != 0) {
        const std::string reason = std::strerror(errno);
        close(listener);
        give_up(fmt::format("there is no socket, {}", reason));
    }
    try {
        folder_ = std::make_unique<PrivateFolder>(room_of_mpi);
    } catch (const deadpoint::IoError& error) {
        close(listener);
        const std::string reason = error.what();
        give_up(reason.substr(0, reason.find('\n')));
    }
    start_mpirun(count, name);
    accept_holders(count, listener);
    close(listener);
}

Places::~Places() { end(); }

void Places::end()
{
    for (const int holder : holders_) {
        close(holder);
    }
    holders_.clear();
    if (mpirun_ > 0 && owner_ == getpid()) {
        for (const int signal : {0, SIGTERM, SIGKILL}) {
            kill(mpirun_, signal);
            if (wait_for_end(mpirun_, longest_end)) {
                break;
            }
        }
    }
    mpirun_ = 0;
    close(log_);
    log_ = -1;
    folder_.reset();
}

void Places::give_up(const std::string& reason)
{
    None none{reason, log()};
    end();
    throw none;
}

void Places::start_mpirun(int count, const std::string& socket)
{
    const auto program = mpirun_program();
    mpirun_ = fork();
    if (mpirun_ == 0) {
        become_mpirun(program, count, socket, log_, folder_->path().string());
    }
    if (mpirun_ < 0) {
        give_up(std::strerror(errno));
    }
}

void Places::accept_holders(int count, int socket)
{
    const auto fail = [&](const std::string& reason) {
        close(socket);
        give_up(reason);
    };
    for (const auto start = Clock::now(); static_cast<int>(holders_.size()) < count;) {
        pollfd wanted{socket, POLLIN, 0};
        int status = 0;
        if (poll(&wanted, 1, 20) > 0) {
            const int holder = accept4(socket, nullptr, nullptr, SOCK_CLOEXEC);
            if (holder < 0) {
                fail(fmt::format("no connection to them, {}", std::strerror(errno)));
            }
            auto environment = is_ours(holder) ? read_environment(holder) : std::string();
            if (environment.empty()) {
                close(holder);
            } else {
                holders_.push_back(holder);
                environments_.push_back(std::move(environment));
            }
        } else if (ended(mpirun_, &status)) {
            mpirun_ = 0;
            const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == not_started;
            fail(missing ? fmt::format("{} cannot be started", mpirun_program()) : "mpirun failed");
        }
        if (Clock::now() - start > longest_start) {
            fail("mpirun started none within half a minute");
        }
    }
}

void Places::take(std::size_t place)
{
    clearenv();
    const auto& all = environments_[place];
    for (std::size_t begin = 0; all[begin] != '\0'; begin = all.find('\0', begin) + 1) {
        const std::string variable(all.c_str() + begin);
        const auto equals = variable.find('=');
        if (equals != std::string::npos) {
            setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 1);
        }
    }
    for (const int holder : holders_) {
        close(holder);
    }
    holders_.clear();
}

bool Places::held()
{
    if (mpirun_ > 0 && ended(mpirun_)) {
        mpirun_ = 0;
    }
    return mpirun_ > 0 && std::ranges::none_of(holders_, [](int holder) {
               pollfd watched{holder, POLLRDHUP, 0};
               return poll(&watched, 1, 0) > 0;
           });
}

std::string Places::log() const
{
    std::string text(8192, '\0');
    const auto size = pread(log_, text.data(), text.size(), 0);
    text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return text.substr(0, text.find_last_not_of('\n') + 1);
}

Places::Quiet::Quiet(const Places& places)
    : out_(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3)), err_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3))
{
    dup2(places.log_, STDOUT_FILENO);
    dup2(places.log_, STDERR_FILENO);
}

Places::Quiet::~Quiet()
{
    dup2(out_, STDOUT_FILENO);
    dup2(err_, STDERR_FILENO);
    close(out_);
    close(err_);
}

int hold_place(const char* socket)
{
    const Address address(socket);
    const int program = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (program < 0 || connect(program, address.get(), address.size) != 0 || !is_ours(program)) {
        return 1;
    }
    std::string text;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        text.append(*variable).push_back('\0');
    }
    text.push_back('\0');
    for (std::size_t sent = 0; sent < text.size();) {
        const auto count = send(program, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
        if (count <= 0) {
            return 1;
        }
        sent += static_cast<std::size_t>(count);
    }
    char end = 0;
    while (read(program, &end, 1) < 0 && errno == EINTR) {
    }
    return 0;
}
