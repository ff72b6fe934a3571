#pragma once

#include "deadpoint/observer.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace spdlog {
class logger;
}

/// Shows the reports of the library on standard error: on a terminal one line that is updated, with
/// the remaining time; elsewhere plain lines, at most one for every tenth of a stage. Results go to
/// standard output, not through this class.
class Console : public deadpoint::Observer {
public:
    struct Options {
        bool quiet = false;    ///< warnings only
        bool verbose = false;  ///< also facts, with the time of day
        bool silent = false;   ///< nothing at all
    };

    explicit Console(const Options& options);
    ~Console() override;

    void stage(std::string_view name) override;
    void progress(double fraction, std::string_view detail) override;
    void info(std::string_view text) override;
    void warn(std::string_view text) override;
    [[nodiscard]] bool cancelled() const override;
    /// Shows a note for the user that does not concern results; it is not written to any file.
    void note(std::string_view text) const;

    /// Shows nothing from now on, but keeps warnings.
    void silence();
    /// Ends the running stage and its line; to be called before anything else is printed.
    void finish();
    /// All warnings so far, in order, each once.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    using Clock = std::chrono::steady_clock;

    void show(double fraction, std::string_view detail);
    void clear_line() const;
    [[nodiscard]] std::string styled(const char* style, std::string_view text) const;

    Options options_;
    bool terminal_ = false;
    bool colours_ = false;
    std::shared_ptr<spdlog::logger> log_;
    std::string stage_;
    Clock::time_point stage_start_;
    Clock::time_point last_shown_;
    double last_fraction_ = 0;
    std::vector<std::string> warnings_;
};
