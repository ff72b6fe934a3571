#include "interrupt.hpp"

#include "deadpoint/full/sweep/sweep.hpp"

#include <csignal>
#include <initializer_list>
#include <string_view>
#include <unistd.h>

namespace {

volatile std::sig_atomic_t stop_wanted = 0;
volatile std::sig_atomic_t asked_to_end = 0;  // set by a user or a shutdown; only these can end the program at once

void ask_for_stop()
{
    if (stop_wanted != 0) {
        return;
    }
    stop_wanted = 1;
    constexpr std::string_view text = "\nstopping after this step; results so far are kept (again to stop at once)\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

extern "C" void on_end(int)
{
    if (asked_to_end != 0) {
        _exit(interrupted_exit_code);
    }
    asked_to_end = 1;
    ask_for_stop();
}

// A terminal that closes sends it several times.
extern "C" void on_hangup(int) { ask_for_stop(); }

// From ourselves: somebody who read our text is gone. The write fails too, and is dealt with there.
extern "C" void on_pipe(int, siginfo_t* info, void*)
{
    if (info->si_pid != getpid()) {
        ask_for_stop();
    }
}

extern "C" void on_quiet_signal(int) { stop_wanted = 1; }

extern "C" void on_ignored(int) {}

void handle(int signal, void (*handler)(int))
{
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal)
{
    struct sigaction action = {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void outlast_failing_writes()
{
    struct sigaction action = {};
    action.sa_sigaction = on_pipe;
    action.sa_flags = SA_RESTART | SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    sigaction(SIGPIPE, &action, nullptr);
    handle(SIGXFSZ, on_ignored);
}

void catch_interrupts()
{
    outlast_failing_writes();
    handle(SIGINT, on_end);
    handle(SIGTERM, on_end);
    if (!is_ignored(SIGHUP)) {  // nohup
        handle(SIGHUP, on_hangup);
    }
    handle(deadpoint::full::stop_signal, on_quiet_signal);
}

void leave_interrupts_to_parent()
{
    outlast_failing_writes();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        handle(signal, SIG_IGN);
    }
    handle(deadpoint::full::stop_signal, on_quiet_signal);
}

bool interrupted() { return stop_wanted != 0; }
