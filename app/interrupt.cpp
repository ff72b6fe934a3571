#include "interrupt.hpp"

#include "deadpoint/study/sweep.hpp"

#include <csignal>
#include <string_view>
#include <unistd.h>

namespace {

volatile std::sig_atomic_t stop_requests = 0;

extern "C" void on_signal(int)
{
    if (stop_requests != 0) {
        _exit(interrupted_exit_code);
    }
    stop_requests = 1;
    constexpr std::string_view text = "\nstopping after this step; results so far are kept (again to stop at once)\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text.data(), text.size());
}

extern "C" void on_quiet_signal(int) { stop_requests = 1; }

}  // namespace

void catch_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = on_quiet_signal;
    sigaction(deadpoint::study::stop_signal, &action, nullptr);
}

bool interrupted() { return stop_requests != 0; }
