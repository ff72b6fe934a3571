#include "system/program.hpp"

#include "interrupt.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace std::chrono_literals;

namespace {

constexpr int not_there = 127;  // the exit code, as of a shell

[[noreturn]] void become(std::vector<std::string> command, std::vector<std::string> settings)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setpgid(0, 0);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGUSR1, SIGXFSZ}) {
        std::signal(signal, SIG_DFL);
    }
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        dup2(nowhere, stream);
    }
    for (auto& setting : settings) {
        putenv(setting.data());
    }
    std::vector<char*> arguments;
    for (auto& argument : command) {
        arguments.push_back(argument.data());
    }
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(not_there);
}

ProgramEnd end_of(int status)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == not_there) {
        return ProgramEnd::missing;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramEnd::done : ProgramEnd::failed;
}

ProgramEnd wait_for(pid_t process, double seconds)
{
    const auto start = std::chrono::steady_clock::now();
    for (int status = 0;;) {
        if (waitpid(process, &status, WNOHANG) != 0) {
            return end_of(status);
        }
        if (interrupted()) {
            return ProgramEnd::stopped;
        }
        if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds) {
            return ProgramEnd::too_long;
        }
        std::this_thread::sleep_for(10ms);
    }
}

}  // namespace

ProgramEnd run_limited(const std::vector<std::string>& command, const std::vector<std::string>& settings,
                       double seconds)
{
    const pid_t process = fork();
    if (process < 0) {
        return ProgramEnd::failed;
    }
    if (process == 0) {
        become(command, settings);
    }
    setpgid(process, process);  // here too: whichever process comes first
    const auto end = wait_for(process, seconds);
    kill(-process, SIGKILL);
    if (end == ProgramEnd::stopped || end == ProgramEnd::too_long) {
        while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    return end;
}
