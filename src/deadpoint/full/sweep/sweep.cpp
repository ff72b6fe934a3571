#include "deadpoint/full/sweep/sweep.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/io/plain_reason.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/machine/model_part.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/tribology/friction/duty.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace deadpoint::full {
namespace {

constexpr int left_unfinished = 130;             // exit code of a process whose point was stopped
constexpr double private_share_of_memory = 0.5;  // share of the prepared memory that a process adds for itself, about

/// A point that runs in a separate process.
struct Worker {
    pid_t process = 0;
    int reason = -1;  ///< end of the pipe through which it reports why it failed
    std::size_t point = 0;
    Clock::time_point start;
};

// As many processes as cores; fewer if the memory does not hold `per_point` bytes for each.
int workers_that_fit(double per_point)
{
    const double fit = per_point > 0 ? 0.8 * available_memory() / per_point : usable_cores();
    return static_cast<int>(std::clamp<double>(fit, 1, usable_cores()));
}

double resident_memory()
{
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// All that the pipe holds; the process at its other end is done.
std::string read_all(int pipe)
{
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        const auto count = read(pipe, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            break;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    close(pipe);
    return text;
}

void write_all(int pipe, const std::string& text)
{
    // A pipe takes 4096 bytes at once; longer texts are cut.
    [[maybe_unused]] const auto written = write(pipe, text.data(), std::min<std::size_t>(text.size(), 4096));
}

/// The points of one group, on a prepared model.
class Group {
public:
    Group(const std::vector<twin::SweepPoint>& points, const std::vector<casefile::Case>& cases,
          const SweepOptions& options, const PointAction& action, Observer& observer,
          std::vector<twin::PointOutcome>& outcomes)
        : points_(points), cases_(cases), options_(options), action_(action), observer_(observer), outcomes_(outcomes)
    {}

    void run(const std::vector<std::size_t>& members)
    {
        std::vector<std::size_t> queue(members.rbegin(), members.rend());
        if (!prepare(queue))
            return;
        const int fit = workers_that_fit(private_share_of_memory * resident_memory());
        workers_ = fem::ranks() > 1 ? 1 : options_.workers > 0 ? options_.workers : fit;
        if (options_.on_prepared)
            options_.on_prepared(press_->machine(observer_), queue.size(), workers_);
        if (workers_ > 1)
            run_side_by_side(queue);
        else
            run_in_turn(queue);
    }

private:
    // Meshes the machine and prepares the model with the first point that can be prepared; points before it have
    // failed.
    bool prepare(std::vector<std::size_t>& queue)
    {
        while (!queue.empty() && !observer_.cancelled()) {
            const auto point = queue.back();
            try {
                start_press(cases_[point]);
                press_->mesh(observer_);
                if (options_.on_meshed)
                    options_.on_meshed(press_->machine(observer_));
                press_->prepare(observer_);
                return true;
            } catch (const Error& error) {
                fail(point, error.what());
                queue.pop_back();
            }
        }
        return false;
    }

    // The next point reuses the meshes of a point before, but not its incomplete model.
    void start_press(const casefile::Case& input)
    {
        if (!press_) {
            press_.emplace(input);
            return;
        }
        press_->drop_model();
        press_->take(input);
    }

    void act(std::size_t point)
    {
        press_->take(cases_[point]);
        action_(points_[point], *press_);
    }

    void run_in_turn(std::vector<std::size_t>& queue)
    {
        while (!queue.empty() && !observer_.cancelled()) {
            const auto point = queue.back();
            queue.pop_back();
            const auto start = Clock::now();
            observer_.stage(points_[point].name);
            try {
                act(point);
                if (!observer_.cancelled())
                    finish(point, seconds_since(start));
            } catch (const Error& error) {
                fail(point, error.what());
            }
        }
    }

    void run_side_by_side(std::vector<std::size_t>& queue)
    {
        observer_.stage("points");
        std::vector<Worker> workers;
        const std::size_t all = queue.size();
        while (!queue.empty() || !workers.empty()) {
            while (!queue.empty() && static_cast<int>(workers.size()) < workers_ && !observer_.cancelled()) {
                workers.push_back(start(queue.back()));
                queue.pop_back();
            }
            if (workers.empty())
                break;
            const auto ended = wait_for_one(workers);
            observer_.progress(1 - static_cast<double>(queue.size() + workers.size()) / static_cast<double>(all),
                               points_[ended].name);
        }
    }

    Worker start(std::size_t point)
    {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0)
            throw IoError(
                fmt::format("cannot start a process for point {}: {}", points_[point].name, std::strerror(errno)));
        const pid_t process = fork();
        if (process < 0)
            throw IoError(fmt::format("cannot start a process for point {}: {}\n  help: run fewer points at a time "
                                      "with --jobs",
                                      points_[point].name, std::strerror(errno)));
        if (process == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            setpgid(0, 0);  // Ctrl-C goes to the parent, which passes it on
            close(ends[0]);
            _exit(work(point, ends[1]));
        }
        close(ends[1]);
        return {process, ends[0], point, Clock::now()};
    }

    // Runs in the child. It must not return into the program, whose objects belong to the parent.
    int work(std::size_t point, int reason) noexcept
    {
        try {
            act(point);
            return observer_.cancelled() ? left_unfinished : 0;
        } catch (const Error& error) {
            write_all(reason, error.what());
            return error.exit_code();
        } catch (const std::exception& error) {
            write_all(reason, plain_reason(error));
            return 1;
        }
    }

    // Returns the point that ended.
    std::size_t wait_for_one(std::vector<Worker>& workers)
    {
        int status = 0;
        pid_t ended = 0;
        while (ended == 0 || (ended < 0 && errno == EINTR)) {
            ended = waitpid(-1, &status, WNOHANG);
            if (ended != 0)
                continue;
            if (observer_.cancelled() && !told_to_stop_) {
                told_to_stop_ = true;
                for (const auto& worker : workers)
                    kill(worker.process, stop_signal);
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        const auto found = std::ranges::find(workers, ended, &Worker::process);
        if (found == workers.end())
            throw IoError("lost the processes that run the points");
        const Worker worker = *found;
        workers.erase(found);
        const auto reason = read_all(worker.reason);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            finish(worker.point, seconds_since(worker.start));
        else if (WIFEXITED(status) && WEXITSTATUS(status) != left_unfinished)
            fail(worker.point, reason);
        else if (WIFSIGNALED(status) && !told_to_stop_)
            fail(worker.point,
                 fmt::format("its process was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))));
        return worker.point;
    }

    void finish(std::size_t point, double seconds)
    {
        outcomes_[point] = {twin::PointOutcome::State::done, {}, seconds};
        observer_.info(fmt::format("{}: {:.1f} s", points_[point].name, seconds));
    }

    void fail(std::size_t point, const std::string& reason)
    {
        outcomes_[point] = {twin::PointOutcome::State::failed, reason, 0};
        observer_.warn(fmt::format("point {} failed: {}", points_[point].name, reason));
    }

    const std::vector<twin::SweepPoint>& points_;
    const std::vector<casefile::Case>& cases_;
    const SweepOptions& options_;
    const PointAction& action_;
    Observer& observer_;
    std::vector<twin::PointOutcome>& outcomes_;
    std::optional<Press> press_;
    int workers_ = 1;
    bool told_to_stop_ = false;
};

using PointGroups = std::vector<std::pair<std::string, std::vector<std::size_t>>>;

/// Points that share meshes and model, under the text of what they share.
PointGroups groups_of(const std::vector<casefile::Case>& cases, const std::vector<std::size_t>& pending)
{
    PointGroups groups;
    for (const auto point : pending) {
        const auto shared = press::model_key(cases[point]);
        auto group = std::ranges::find(groups, shared, &PointGroups::value_type::first);
        if (group == groups.end())
            group = groups.insert(groups.end(), {shared, {}});
        group->second.push_back(point);
    }
    return groups;
}

}  // namespace

void scale_sizes(casefile::Case& input, double factor)
{
    input.numerics.size *= factor;
    for (auto& [name, part] : input.parts)
        if (part.size)
            *part.size *= factor;
}

std::size_t most_alike(const std::vector<casefile::Case>& cases, const std::vector<std::size_t>& pending)
{
    std::size_t most = 0;
    for (const auto& [shared, members] : groups_of(cases, pending))
        most = std::max(most, members.size());
    return most;
}

std::vector<twin::PointOutcome> run_points(const std::vector<twin::SweepPoint>& points,
                                           const std::vector<casefile::Case>& cases,
                                           const std::vector<std::size_t>& pending, const SweepOptions& options,
                                           const PointAction& action, Observer& observer)
{
    std::vector<twin::PointOutcome> outcomes(points.size());
    for (const auto& [shared, members] : groups_of(cases, pending))
        if (!observer.cancelled())
            Group(points, cases, options, action, observer, outcomes).run(members);
    return outcomes;
}

}  // namespace deadpoint::full
