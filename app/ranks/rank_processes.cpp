#include "ranks/rank_processes.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/full/sweep/sweep.hpp"
#include "interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto longest_opening = 60s;
constexpr auto longest_end = 10s;  // of the others, after the first rank has ended well

}  // namespace

struct RankProcesses::Shared {
    std::atomic<int> opened{0};
    std::atomic<int> begin{0};
    std::atomic<int> first_rank{0};     // a process
    std::atomic<int> first_to_fail{0};  // a process
    std::atomic<int> failure{0};        // the exit code that it wants
};

RankProcesses::RankProcesses(int count) : count_(count), owner_(getpid())
{
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        throw deadpoint::IoError(fmt::format("no processes can be started: {}", std::strerror(errno)));
    }
    shared_ = new (memory) Shared;
}

RankProcesses::~RankProcesses()
{
    if (owner_ != getpid()) {
        return;  // a rank may still use what is shared
    }
    kill_all();
    for (const pid_t process : living_) {
        while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    munmap(shared_, sizeof(Shared));
}

bool RankProcesses::start()
{
    const pid_t process = fork();
    if (process < 0) {
        throw deadpoint::IoError(fmt::format("cannot start a process for each of {} ranks: {}\n  help: use fewer with "
                                             "--ranks",
                                             count_, std::strerror(errno)));
    }
    if (process > 0) {
        living_.push_back(process);
        return false;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != owner_) {
        _exit(1);  // it was killed before
    }
    living_.clear();
    return true;
}

void RankProcesses::opened(int rank)
{
    if (rank == 0) {
        shared_->first_rank = getpid();
    }
    ++shared_->opened;
    while (shared_->begin == 0) {
        std::this_thread::sleep_for(1ms);
    }
}

void RankProcesses::require_first_failure()
{
    int none = 0;
    while (!shared_->first_to_fail.compare_exchange_strong(none, getpid())) {
        pause();
    }
}

void RankProcesses::fail(int exit_code)
{
    shared_->failure = exit_code;
    _exit(exit_code);
}

bool RankProcesses::wait_until_opened()
{
    for (const auto start = Clock::now(); Clock::now() - start < longest_opening;) {
        if (shared_->opened == count_) {
            shared_->begin = 1;
            return true;
        }
        RanksEnd ignored;
        if (reap_one(ignored)) {
            break;
        }
        std::this_thread::sleep_for(1ms);
    }
    kill_all();
    return false;
}

RanksEnd RankProcesses::wait(const std::function<bool()>& can_go_on)
{
    RanksEnd end;
    bool told = false;
    auto first_rank_lived = Clock::now();
    while (!living_.empty()) {
        if (reap_one(end)) {
            continue;
        }
        const bool first_lives = std::ranges::find(living_, shared_->first_rank.load()) != living_.end();
        if (first_lives) {
            first_rank_lived = Clock::now();
        }
        if (shared_->failure != 0) {
            end.exit_code = shared_->failure;
            kill_all();
        } else if (!end.message.empty() || Clock::now() - first_rank_lived > longest_end) {
            kill_all();
        } else if (first_lives && !killed_ && !can_go_on()) {
            end = {1, "the connection between the ranks was lost\n  help: start the command again, or use one rank "
                      "(--ranks 1)"};
            kill_all();
        } else if (!told && interrupted()) {
            told = true;
            tell_all(deadpoint::full::stop_signal);
        }
        std::this_thread::sleep_for(10ms);
    }
    return end;
}

// True if one has ended; what that means for the program is in `end`.
bool RankProcesses::reap_one(RanksEnd& end)
{
    for (auto process = living_.begin(); process != living_.end(); ++process) {
        int status = 0;
        if (waitpid(*process, &status, WNOHANG) <= 0) {
            continue;
        }
        const pid_t ended = *process;
        living_.erase(process);
        if (WIFEXITED(status) && ended == shared_->first_rank && end.message.empty()) {
            end.exit_code = WEXITSTATUS(status);
        }
        if (shared_->failure != 0) {
            end.exit_code = shared_->failure;
        } else if (WIFSIGNALED(status) && !killed_ && end.message.empty()) {
            constexpr int of_signals = 128;  // as a shell shows it
            end = {of_signals + WTERMSIG(status),
                   fmt::format("one of {} ranks, process {}, was ended by signal {} ({})\n  help: if memory ran out, "
                               "use fewer ranks (--ranks 1) or make the mesh coarser (--size 1.5)",
                               count_, ended, WTERMSIG(status), strsignal(WTERMSIG(status)))};
        }
        return true;
    }
    return false;
}

void RankProcesses::kill_all()
{
    killed_ = true;
    tell_all(SIGKILL);
}

void RankProcesses::tell_all(int signal) const
{
    for (const pid_t process : living_) {
        kill(process, signal);
    }
}
