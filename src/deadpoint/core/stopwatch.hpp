#pragma once

#include "deadpoint/observer.hpp"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

/// Wall time of the stages of a run, in the order in which they ran.
namespace deadpoint {

using Clock = std::chrono::steady_clock;

/// Wall time [s].
inline double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

class Stopwatch {
public:
    explicit Stopwatch(Observer& observer) : observer_(observer) {}
    /// Ends the running stage and tells the observer of the next one.
    void start(const std::string& stage)
    {
        stop();
        observer_.stage(stage);
        stage_ = stage;
        since_ = Clock::now();
    }
    void stop()
    {
        if (!stage_.empty())
            times_.emplace_back(stage_, seconds());
        stage_.clear();
    }
    /// Wall time of the running stage [s].
    [[nodiscard]] double seconds() const { return seconds_since(since_); }
    /// Stage, wall time [s].
    [[nodiscard]] const std::vector<std::pair<std::string, double>>& times() const { return times_; }
    /// Records a share of the last stage as a separate stage; none if the share is zero.
    void split_last(const std::string& stage, double seconds)
    {
        times_.back().second -= seconds;
        if (seconds > 0)
            times_.emplace_back(stage, seconds);
    }

private:
    Observer& observer_;
    std::string stage_;
    Clock::time_point since_;
    std::vector<std::pair<std::string, double>> times_;
};

}  // namespace deadpoint
