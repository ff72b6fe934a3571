/// Requirement: `report --pictures` draws the page that it has made, whatever its folder is called, in a profile that
/// nobody else can open or prepare; and a browser that is missing, fails or hangs is an error with a remedy that leaves
/// neither processes nor files behind.
#include "command.hpp"

#include <chrono>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <thread>
#include <utility>

namespace {

/// Results of loads, and a browser that a script plays, before all others in PATH.
struct Drawn {
    explicit Drawn(const std::string& name, const std::string& script) : results(folder.path / name)
    {
        fs::create_directories(folder.path / "bin");
        fs::create_directories(temporary);
        const auto browser = folder.file("bin/chromium", std::string("#!/bin/sh\n") + words + script);
        fs::permissions(browser, fs::perms::owner_all);
        REQUIRE(::run("", fmt::format("loads -q {}/study/balanced-crank.toml -o '{}'", DEADPOINT_TEST_DATA,
                                      results.string()))
                    .code == 0);
    }
    [[nodiscard]] Outcome report(const std::string& settings = "", const std::string& more = "") const
    {
        return ::run(
            fmt::format("PATH={}:$PATH TMPDIR={} {}", (folder.path / "bin").string(), temporary.string(), settings),
            fmt::format("report '{}' --pictures '{}' {}", results.string(), pictures.string(), more));
    }
    [[nodiscard]] bool nothing_is_left() const
    {
        return fs::is_empty(temporary) && (!fs::exists(pictures) || fs::is_empty(pictures));
    }

    /// Puts words of the command line into variables of the shell.
    static constexpr const char* words =
        "for word; do case $word in --screenshot=*) picture=${word#*=};; --user-data-dir=*) profile=${word#*=};; esac; "
        "done\n";
    ScratchFolder folder;
    fs::path results, temporary = folder.path / "tmp", pictures = folder.path / "pictures";
};

/// Draws nothing, but notes what it was asked: rights of the folder around the profile, and the address.
std::string notes_and_draws(const fs::path& log)
{
    return fmt::format("mkdir \"$profile\" && stat -c %a \"$(dirname \"$profile\")\" >>'{0}'\nprintf '%s\\n' \"$word\" "
                       ">>'{0}'\necho png >\"$picture\"\n",
                       log.string());
}

/// Within some seconds; a process without parents may be a zombie for a moment.
bool has_ended(const std::string& process)
{
    const auto stat = "/proc/" + process.substr(0, process.find('\n')) + "/stat";
    for (int i = 0; i < 100; ++i) {
        if (!fs::exists(stat) || has(content(stat), ") Z "))
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

}  // namespace

TEST_CASE("pictures are drawn from the page of a folder with any name, in a profile of their own")
{
    const ScratchFolder outside;
    const auto log = outside.path / "log";
    const Drawn drawn("50% off #1 what? \xC3\xBC", notes_and_draws(log));
    const auto outcome = drawn.report();
    CAPTURE(outcome.text);
    CHECK(outcome.code == 0);
    const auto asked = content(log);
    // RFC 3986: a blank is %20, # %23, % %25, ? %3F; the letter u-umlaut is two bytes of UTF-8.
    const auto address =
        fmt::format("file://{}/50%25%20off%20%231%20what%3F%20%C3%BC/report.html#picture=", drawn.folder.path.string());
    for (const char* pose : {"oblique", "front", "side", "cut"}) {
        CHECK(has(asked, address + pose + "\n"));
        CHECK(content(drawn.pictures / fmt::format("machine-{}.png", pose)) == "png\n");
    }
    CHECK(asked.find("700\n") == 0);
    CHECK(fs::is_empty(drawn.temporary));
    CHECK(std::distance(fs::directory_iterator(drawn.pictures), {}) == 4);

    const auto again = drawn.report();
    CHECK(again.code == 5);
    CHECK(has(again.text, "machine-oblique.png' exists\n  help: choose another name, or add --force"));
    CHECK(drawn.report("", "--force").code == 0);
}

TEST_CASE("a browser that hangs is stopped with all that it has started")
{
    const ScratchFolder outside;
    const auto log = outside.path / "log";
    const Drawn drawn("results", fmt::format("mkdir \"$profile\"; sleep 600 & echo $! >>'{}'; wait\n", log.string()));
    const auto outcome = drawn.report("DEADPOINT_BROWSER_SECONDS=0.5");
    CHECK(outcome.code == 5);
    CHECK(has(outcome.text, "Chromium took longer than 0.5 s for a picture and was stopped"));
    CHECK(has(outcome.text, "DEADPOINT_BROWSER_SECONDS=600"));
    CHECK(drawn.nothing_is_left());
    CHECK(has_ended(content(log)));
    const auto nonsense = drawn.report("DEADPOINT_BROWSER_SECONDS=soon");
    CHECK(nonsense.code == 2);
    CHECK(has(nonsense.text, "DEADPOINT_BROWSER_SECONDS is 'soon'"));
}

TEST_CASE("a browser that fails, draws nothing or is not there is an error with what to do")
{
    for (const auto& [script, said] :
         {std::pair{"exit 3\n", "Chromium made no picture"}, std::pair{"exit 0\n", "Chromium made no picture"},
          std::pair{"exit 127\n", "Chromium, which was not found"}}) {
        CAPTURE(script);
        const Drawn drawn("results", script);
        const auto only = fmt::format("PATH={}", (drawn.folder.path / "bin").string());
        const auto outcome = drawn.report(only);
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, said));
        CHECK(has(outcome.text, "help: "));
        CHECK(drawn.nothing_is_left());
    }
}

TEST_CASE("Ctrl-C ends the browser and leaves nothing of it")
{
    const Drawn drawn("results", "mkdir \"$profile\"; kill -INT $PPID; exec sleep 600\n");
    const auto outcome = drawn.report();
    CHECK(outcome.code == 130);
    CHECK(drawn.nothing_is_left());
}
