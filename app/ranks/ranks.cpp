#include "ranks/ranks.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/space/rank_count.hpp"
#include "deadpoint/io/resources.hpp"
#include "errors.hpp"
#include "interrupt.hpp"
#include "output.hpp"
#include "ranks/launcher.hpp"
#include "ranks/places.hpp"
#include "ranks/rank_processes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <unistd.h>

using namespace deadpoint;
using report::ResultFolder;

namespace {

constexpr int most_ranks = 1024;

/// The ranks have ended; thrown in the process that started them, so that it leaves what it holds in order.
struct AllEnded {
    int exit_code;
};

/// From the environment. @throws InputError
int default_count()
{
    const char* text = std::getenv("DEADPOINT_RANKS");
    if (text == nullptr || *text == '\0') {
        return 0;
    }
    char* end = nullptr;
    const long count = std::strtol(text, &end, 10);
    if (*end != '\0' || count < 1 || count > most_ranks) {
        throw InputError(fmt::format("DEADPOINT_RANKS is '{}'\n  help: set it to a number of ranks, 1 to {}, or not at "
                                     "all",
                                     text, most_ranks));
    }
    return static_cast<int>(count);
}

[[noreturn]] void refuse_other_count(int there, int wanted)
{
    throw InputError(fmt::format("--ranks {} was given, but this program was started on {} rank{}\n  help: leave out "
                                 "--ranks where mpirun or srun starts the ranks",
                                 wanted, there, there == 1 ? "" : "s"));
}

}  // namespace

void add_rank_options(CLI::App& command, RankOptions& options)
{
    command
        .add_option(
            "--ranks", options.count,
            "number of processes that solve the fields together; default: as many as cores, memory and mesh allow")
        ->type_name("N")
        ->check(CLI::Range(1, most_ranks));
}

Ranks::Ranks(const RankOptions& wanted, Console& of_all) : console(of_all), wanted_(wanted)
{
    const auto by = launcher();
    const int there = launched_ranks();
    if (by == Launcher::ranks && there > 1 && wanted_.count > 0 && wanted_.count != there) {
        refuse_other_count(there, wanted_.count);
    }
    fem::require_room();
    const bool own = by == Launcher::none || (wanted_.count > 0 && there <= 1);
    if (own) {
        wanted_.count = wanted_.count > 0 ? wanted_.count : default_count();
        catch_interrupts();
        return;
    }
    if (by == Launcher::ranks) {
        require_launcher();
    } else {
        leave_mpi_to_itself();
    }
    open();
    catch_interrupts();  // after MPI, which installs its own handlers
}

Ranks::~Ranks() = default;

void Ranks::open()
{
    session_ = std::make_unique<fem::Session>();
    first = session_->rank() == 0;
    if (!first) {
        console.silence();
    }
}

void Ranks::spread(const std::function<std::size_t()>& cells)
{
    if (!session_) {
        spread_to(wanted_.count > 0 ? wanted_.count : helpful(cells));
    }
}

int Ranks::helpful(const std::function<std::size_t()>& cells) const
{
    const int cores = usable_cores();
    if (cores == 1) {
        return 1;
    }
    const double busy = others_.busy_cores();
    const int free = std::max(1, static_cast<int>(std::lround(cores - busy)));
    const int count = free > 1 ? fem::rank_count(cells(), free, available_memory()) : 1;
    console.info(fmt::format("{} of {} cores are free: {} rank{}", free, cores, count, count == 1 ? "" : "s"));
    return count;
}

void Ranks::spread_if_wanted()
{
    if (!session_) {
        spread_to(std::max(1, wanted_.count));
    }
}

void Ranks::stay_alone(const std::string& what)
{
    const int wanted = session_ ? session_->size() : wanted_.count;
    if (wanted > 1) {
        throw InputError(fmt::format(
            "{} is made by one process, and {} are wanted\n  help: use --ranks 1, and no mpirun", what, wanted));
    }
    wanted_.count = 1;
}

void Ranks::spread_to(int count)
{
    if (count == 1 || !start(count)) {
        leave_mpi_to_itself();
        open();
        catch_interrupts();
    }
}

// Returns true in each rank, and false in this process if there are none.
bool Ranks::start(int count)
{
    console.finish();
    flush_out();
    const auto note = [&](const std::string& reason, const std::string& log) {
        console.note(fmt::format("one process computes, since no {} ranks could be started: {} (--verbose tells more, "
                                 "--ranks 1 starts none)",
                                 count, reason));
        console.info(log);
    };
    try {
        places_ = std::make_unique<Places>(count);
        processes_ = std::make_unique<RankProcesses>(count);
        for (int place = 0; place < count; ++place) {
            if (processes_->start()) {
                begin_as_rank(place, count);
                return true;
            }
        }
        if (processes_->wait_until_opened()) {
            const auto end = processes_->wait([this] { return places_->held(); });
            if (!end.message.empty()) {
                print_err("error: {}\n", end.message);
            }
            throw AllEnded{end.exit_code};
        }
        note("MPI did not begin in them", places_->log());
    } catch (const Places::None& none) {
        note(none.reason, none.log);
    } catch (const IoError& error) {
        note("the system gives no more processes", error.what());
    }
    processes_.reset();
    places_.reset();
    return false;
}

void Ranks::begin_as_rank(int place, int count)
{
    leave_interrupts_to_parent();
    {
        const Places::Quiet quiet(*places_);
        places_->take(static_cast<std::size_t>(place));
        fem::use_one_thread();
        open();
    }
    leave_interrupts_to_parent();  // again after MPI, which installs its own handlers
    if (session_->size() != count) {
        _exit(1);  // an mpirun of another MPI
    }
    processes_->opened(session_->rank());
}

void Ranks::require_one(const std::string& command) const
{
    if (fem::ranks() > 1) {
        throw InputError(
            fmt::format("{} computes on one process\n  help: call it without mpirun; it uses all cores", command));
    }
}

int Ranks::explain_failure()
{
    const auto error = std::current_exception();
    if (agree) {
        return first ? explain(error) : exit_code_of(error);
    }
    if (processes_) {
        processes_->require_first_failure();
    }
    console.finish();
    const int exit_code = explain(error);
    flush_out();
    if (processes_) {
        processes_->fail(exit_code);
    }
    if (session_ && session_->size() > 1) {
        fem::abort_ranks(exit_code);
    }
    return exit_code;
}

int on_ranks(const RankOptions& wanted, const Console::Options& options, const std::function<int(Ranks&)>& work)
{
    Console console(options);
    Ranks ranks(wanted, console);
    try {
        const int exit_code = work(ranks);
        flush_out();
        return exit_code;
    } catch (const AllEnded& end) {
        return end.exit_code;
    } catch (...) {
        return ranks.explain_failure();
    }
}

void on_first_rank(bool first, const std::function<void()>& work)
{
    std::string error;
    if (first) {
        try {
            work();
        } catch (const IoError& reason) {
            error = reason.what();
        }
    }
    error = fem::from_first_rank(error);
    if (!error.empty()) {
        throw IoError(error);
    }
}

std::string start_folder(bool first, const std::function<std::unique_ptr<ResultFolder>()>& start,
                         std::unique_ptr<ResultFolder>& folder)
{
    on_first_rank(first, [&] { folder = start(); });
    return fem::from_first_rank(folder ? folder->path().string() : std::string{});
}

void leave_to_first(const Ranks& ranks, std::unique_ptr<ResultFolder>& folder)
{
    if (!ranks.first && folder) {
        folder->disown();
        folder.reset();
    }
}
