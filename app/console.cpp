#include "console.hpp"

#include "deadpoint/report/tables/table.hpp"
#include "interrupt.hpp"
#include "output.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <unistd.h>

using deadpoint::report::display_width;
using deadpoint::report::duration_text;

namespace {

constexpr const char* yellow = "\033[33m";
constexpr const char* grey = "\033[90m";

double seconds_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t terminal_width()
{
    winsize size = {};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// What is left of a stage, as long as an estimate means anything.
std::string time_left(double fraction, double elapsed)
{
    if (fraction < 0.02 || elapsed < 1 || fraction >= 1) {
        return {};
    }
    return duration_text(elapsed * (1 - fraction) / fraction) + " left";
}

std::string bar(double fraction)
{
    constexpr int width = 20;
    const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
    std::string result;
    for (int i = 0; i < width; ++i) {
        result += i < full ? "━" : "╌";
    }
    return result;
}

}  // namespace

Console::Console(const Options& options)
    : options_(options), terminal_(isatty(STDERR_FILENO) == 1),
      colours_(terminal_ && std::getenv("NO_COLOR") == nullptr),
      log_(std::make_shared<spdlog::logger>("deadpoint", std::make_shared<spdlog::sinks::stderr_sink_mt>()))
{
    log_->set_pattern("%H:%M:%S  %v");
}

Console::~Console() { finish(); }

std::string Console::styled(const char* style, std::string_view text) const
{
    return colours_ ? fmt::format("{}{}\033[0m", style, text) : std::string(text);
}

void Console::clear_line() const
{
    if (terminal_ && !stage_.empty() && !options_.quiet && !options_.silent) {
        write_err("\r\033[K");
    }
}

void Console::stage(std::string_view name)
{
    finish();
    stage_ = name;
    stage_start_ = last_shown_ = Clock::now();
    last_fraction_ = 0;
    if (options_.quiet || options_.silent) {
        return;
    }
    if (terminal_) {
        show(0, "");
    } else {
        print_err("{}\n", stage_);
    }
}

void Console::progress(double fraction, std::string_view detail)
{
    if (options_.quiet || options_.silent || stage_.empty()) {
        return;
    }
    const double pause = seconds_since(last_shown_);
    // A log gets a line for each tenth of the work, and each minute if a tenth takes longer.
    const bool due = terminal_ ? pause > 0.1 : pause > 60 || (pause > 2 && fraction >= last_fraction_ + 0.1);
    if (due) {
        last_shown_ = Clock::now();
        last_fraction_ = fraction;
        show(fraction, detail);
    }
}

void Console::show(double fraction, std::string_view detail)
{
    const std::string left = time_left(fraction, seconds_since(stage_start_));
    if (!terminal_) {
        print_err("  {:3.0f} %  {}{}{}\n", 100 * fraction, detail, left.empty() ? "" : ", ", left);
        return;
    }
    std::string line = fmt::format("  {:<12} {} {:3.0f} %  {}{}{}", stage_, bar(fraction), 100 * fraction, detail,
                                   left.empty() || detail.empty() ? "" : ", ", left);
    while (display_width(line) >= terminal_width()) {
        line.pop_back();
    }
    write_err("\r\033[K" + deadpoint::one_line(line));
}

void Console::finish()
{
    if (stage_.empty()) {
        return;
    }
    if (terminal_ && !options_.quiet && !options_.silent) {
        const double elapsed = seconds_since(stage_start_);
        const std::string time = elapsed < 10 ? fmt::format("{:.1f} s", elapsed) : duration_text(elapsed);
        write_err(fmt::format("\r\033[K  {:<12} {}\n", stage_, styled(grey, time)));
    }
    stage_.clear();
}

void Console::silence() { options_.silent = true; }

void Console::info(std::string_view text)
{
    if (options_.verbose && !options_.silent) {
        clear_line();
        log_->info("{}", deadpoint::printable(text));
        log_->flush();
    }
}

void Console::warn(std::string_view text)
{
    if (std::ranges::find(warnings_, text) != warnings_.end()) {
        return;
    }
    warnings_.emplace_back(text);
    if (!options_.silent) {
        clear_line();
        write_err(fmt::format("{} {}\n", styled(yellow, "warning:"), deadpoint::printable(text)));
    }
}

void Console::note(std::string_view text) const
{
    if (!options_.silent) {
        clear_line();
        print_err("note: {}\n", text);
    }
}

bool Console::cancelled() const { return interrupted(); }
