/// Requirement: a result that is finished is never lost, whoever runs what at the same time and whichever call fails or
/// is the last one of a process; nothing fails without a word; and a run outlasts what happens to those who read it.
#include "command.hpp"
#include "deadpoint/report/folder/result_files.hpp"

#include <chrono>
#include <csignal>
#include <doctest/doctest.h>
#include <sstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <vector>

using deadpoint::report::foreign_files;
using deadpoint::report::ResultFiles;

namespace {

const std::string two_blocks = DEADPOINT_TEST_DATA "/cli/two-blocks.toml";

std::string run_into(const fs::path& target, const std::string& more = {})
{
    return fmt::format("run {} --quiet -o {} {}", two_blocks, target.string(), more);
}

/// Whether every file that a folder's list names is there as it was written, and no other.
bool is_whole(const fs::path& folder)
{
    try {
        const ResultFiles files(folder);
        for (const auto& [name, listed] : files.listed())
            files.check(name);
        return foreign_files(folder).empty() && files.listed().contains("summary.json");
    } catch (const std::exception&) {
        return false;
    }
}

/// The probe's first temperature, by which results are told apart [degC].
std::string start_temperature(const fs::path& folder)
{
    const auto history = content(folder / "history.csv");
    const auto row = history.find("\n0,");
    return row == std::string::npos ? "none" : history.substr(row + 3, history.find_first_of(",\n", row + 3) - row - 3);
}

std::vector<std::string> names_in(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    return names;
}

int count_of(const fs::path& counts, const std::string& call)
{
    std::istringstream lines(content(counts));
    std::string name;
    for (int count = 0; lines >> name >> count;)
        if (name == call)
            return count;
    return 0;
}

/// Numbers from 1 to `count`: all, or as many spread over them as a test of kills makes.
std::vector<int> spread(int count)
{
    std::vector<int> numbers;
    const int steps = std::min(count, kills() / 3);
    for (int i = 1; i <= steps; ++i)
        numbers.push_back(i * count / steps);
    return numbers;
}

constexpr const char* warm = "--force --set 'machine.initial_temperature=40 degC'";

}  // namespace

TEST_CASE("whichever write, sync or rename fails or is the last, the old or the new result is whole")
{
    const ScratchFolder folder, spare;
    const auto target = folder.path / "result", counts = spare.path / "counts";
    REQUIRE(run("", run_into(target)).code == 0);
    fs::copy(target, spare.path / "old", fs::copy_options::recursive);
    const auto whole = content(target / "report.html").size();
    REQUIRE(whole > 100'000);
    REQUIRE(run(failing(folder.path, "none:0:0", counts), run_into(target, warm)).code == 0);
    for (const std::string call : {"write", "fsync", "rename", "renameat2"}) {
        const int count = count_of(counts, call);
        CAPTURE(call);
        REQUIRE(count > 0);
        for (const int number : spread(count))
            for (const std::string what : {"5", "kill"}) {  // EIO
                CAPTURE(number);
                CAPTURE(what);
                fs::remove_all(folder.path);
                fs::create_directories(folder.path);
                fs::copy(spare.path / "old", target, fs::copy_options::recursive);
                const auto outcome =
                    run(failing(folder.path, fmt::format("{}:{}:{}", call, number, what)), run_into(target, warm));
                const auto start = start_temperature(target);
                CAPTURE(outcome.text);
                CHECK(is_whole(target));
                CHECK((start == "20" || start == "40"));
                if (what == "kill") {
                    CHECK(outcome.code == 137);
                    CHECK(run("", run_into(target, warm)).code == 0);
                    CHECK(start_temperature(target) == "40");
                } else if (outcome.code == 0) {
                    CHECK(start == "40");
                    CHECK((fs::exists(target / "report.html") || has(outcome.text, "report.html is missing")));
                } else {
                    CHECK(outcome.code == 5);
                    CHECK(has(outcome.text, "Input/output error"));
                }
                for (const auto& name : names_in(folder.path)) {
                    CAPTURE(name);
                    CHECK((name == "result" || name.starts_with("result.kept-")));
                }
            }
    }
}

TEST_CASE("whichever read fails, no result is made of the part that came")
{
    const ScratchFolder folder, spare;
    const auto target = folder.path / "result", counts = spare.path / "counts";
    fs::copy(two_blocks, folder.path / "case.toml");
    REQUIRE(run("", run_into(folder.path / "first")).code == 0);
    const auto line = fmt::format("run {0}/case.toml --quiet --from {0}/first -o {0}/result", folder.path.string());
    REQUIRE(run(failing(folder.path, "none:0:0", counts), line).code == 0);
    const int count = count_of(counts, "read");
    REQUIRE(count > 2);
    for (const int number : spread(count)) {
        CAPTURE(number);
        fs::remove_all(target);
        const auto outcome = run(failing(folder.path, fmt::format("read:{}:5", number)), line);
        CAPTURE(outcome.text);
        if (outcome.code == 0)
            CHECK(has(outcome.text, "report.html is missing"));
        else
            CHECK(outcome.code == 5);
        CHECK((has(outcome.text, "Input/output error") || has(outcome.text, "cannot be read")));
        CHECK(fs::exists(target) == (outcome.code == 0));
    }
}

TEST_CASE("a result that another run finishes while this one syncs is not replaced, and neither is lost")
{
    const ScratchFolder folder, spare;
    const auto target = folder.path / "result", other = spare.path / "other";
    REQUIRE(run("", run_into(other)).code == 0);
    for (const std::string call : {"fsync:1", "renameat2:1"}) {
        CAPTURE(call);
        fs::remove_all(folder.path);
        fs::create_directories(folder.path);
        const auto outcome =
            run(failing(folder.path, fmt::format("{}:cp -r {} {}", call, other.string(), target.string())),
                run_into(target, "--set 'machine.initial_temperature=40 degC'"));
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "exists already and is not overwritten"));
        CHECK(start_temperature(target) == "20");
        CHECK(is_whole(target));
        const auto names = names_in(folder.path);
        REQUIRE(names.size() == 2);
        const auto kept = folder.path / (names[0] == "result" ? names[1] : names[0]);
        CHECK(has(outcome.text, "the results are in '" + kept.string() + "'"));
        CHECK(is_whole(kept));
        CHECK(start_temperature(kept) == "40");
    }
}

TEST_CASE("of runs started together into one folder one is done, and the others are told whose it is")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    std::vector<Outcome> outcomes(4);
    std::vector<std::thread> runs;
    for (auto& outcome : outcomes)
        runs.emplace_back([&] { outcome = run("", run_into(target)); });
    for (auto& one : runs)
        one.join();
    int done = 0;
    for (const auto& outcome : outcomes) {
        done += outcome.code == 0 ? 1 : 0;
        CHECK((outcome.code == 0 || outcome.code == 5));
        if (outcome.code != 0)
            CHECK((has(outcome.text, "' is being written by process ") || has(outcome.text, "exists already")));
    }
    CHECK(done == 1);
    CHECK(is_whole(target));
    CHECK(names_in(folder.path).size() == 1);
}

TEST_CASE("a study is not computed by two at once, nor does it take a folder that is none of its own")
{
    const ScratchFolder folder;
    const auto study =
        folder.file("study.toml", fmt::format("format = 1\nname = \"two\"\nbase = \"{}\"\n[[sets]]\nname = \"s\"\n"
                                              "[[sets.axes]]\nkey = \"machine.ambient\"\n"
                                              "values = [\"20 degC\", \"25 degC\"]\n",
                                              two_blocks));
    const auto target = folder.path / "study";
    const auto line = fmt::format("sweep {} --allow-outside --quiet -o {}", study.string(), target.string());
    const auto held = run(fmt::format("flock {}.lock", target.string()), line);  // as a second sweep would
    CHECK(held.code == 5);
    fs::remove(target.string() + ".lock");
    fs::create_directories(target / "points");
    folder.file("study/points/notes.txt", "mine");
    const auto foreign = run("", line);
    CHECK(foreign.code == 5);
    CHECK(has(foreign.text, "holds no study"));
    fs::remove_all(target);
    CHECK(run("", line).code == 0);
    const auto replaced = run("", run_into(target, "--force"));
    CHECK(replaced.code == 5);
    CHECK(has(replaced.text, "holds a study"));
    CHECK(names_in(folder.path).size() == 2);
}

TEST_CASE("nothing is added to a result while a run replaces it")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    REQUIRE(run("", run_into(target)).code == 0);
    const auto reference =
        folder.file("measured.toml", "format = 1\nname = \"bench\"\nsource = \"made up\"\n[[rises]]\ntime = \"5 min\"\n"
                                     "values = { top = \"1 K\" }\n");
    const auto held = fmt::format("flock {}.lock", target.string());  // as the run would
    for (const auto& line : {fmt::format("report {}", target.string()),
                             fmt::format("compare {} {}", target.string(), reference.string())}) {
        CAPTURE(line);
        const auto refused = run(held, line);
        CHECK(refused.code == 5);
        CHECK(has(refused.text, "is being written"));
        CHECK(is_whole(target));
        CHECK(run("", line).code == 0);
        CHECK(is_whole(target));
    }
    CHECK(fs::exists(target / "compare.json"));
}

TEST_CASE("where the file system neither swaps names nor keeps taken ones, nothing is lost either")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto without = failing(folder.path, "renameat2:0:22");  // EINVAL
    CHECK(run(without, run_into(target)).code == 0);
    const auto refused = run(without, run_into(target));
    CHECK(refused.code == 5);
    CHECK(run(without, run_into(target, warm)).code == 0);
    CHECK(start_temperature(target) == "40");
    CHECK(names_in(folder.path).size() == 1);
    const auto taken = run(
        failing(folder.path, fmt::format("renameat2:1:mkdir {0} && touch {0}/mine", (folder.path / "other").string())),
        run_into(folder.path / "other"));
    CHECK(taken.code == 5);
    CHECK(names_in(folder.path / "other") == std::vector<std::string>{"mine"});
}

TEST_CASE("killed between the two renames of such a file system, a result gets its name back")
{
    const ScratchFolder folder, spare;
    const auto target = folder.path / "result", counts = spare.path / "counts";
    REQUIRE(run("", run_into(target)).code == 0);
    REQUIRE(run(failing(folder.path, "renameat2:0:22", counts), run_into(target, "--force")).code == 0);
    const auto last = fmt::format("renameat2:0:22;rename:{}:kill", count_of(counts, "rename"));
    CHECK(run(failing(folder.path, last), run_into(target, warm)).code == 137);
    CHECK_FALSE(fs::exists(target));
    const auto next = run("", run_into(target));
    CHECK(next.code == 5);
    CHECK(has(next.text, "note: '" + target.string() + "' was restored"));
    CHECK(has(next.text, "note: complete results of a run that ended before it could rename them are in '"));
    CHECK(is_whole(target));
    CHECK(start_temperature(target) == "20");
    const auto names = names_in(folder.path);
    REQUIRE(names.size() == 2);
    CHECK(start_temperature(folder.path / (names[0] == "result" ? names[1] : names[0])) == "40");
}

TEST_CASE("--force replaces neither the case's folder nor a folder with files of the user")
{
    const ScratchFolder folder;
    const auto own = folder.path / "press";
    fs::create_directories(own);
    fs::copy(two_blocks, own / "case.toml");
    folder.file("press/notes.txt", "mine");
    const auto line = fmt::format("run {}/case.toml --quiet --force -o ", own.string());
    for (const auto& target : {own, own / ".." / "press", folder.path}) {
        const auto outcome = run("", line + target.string());
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "is not replaced"));
        CHECK_FALSE(has(outcome.text, "time steps"));
    }
    CHECK(content(own / "notes.txt") == "mine");
    CHECK(content(own / "case.toml") == content(two_blocks));
}

TEST_CASE("an output that is closed, full or not read ends no run")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto shell = [&](const std::string& command, const std::string& streams) {
        fs::remove_all(target);
        const auto said = (folder.path / "said").string();
        const int status =
            std::system(fmt::format("( {} {} {} ) 2>{} </dev/null", DEADPOINT_COMMAND, command, streams, said).c_str());
        return Outcome{WEXITSTATUS(status), content(said)};
    };
    const auto line = fmt::format("run {} -v -o {}", two_blocks, target.string());
    for (const auto* streams : {">/dev/null 2>&-", ">/dev/null 2>/dev/full", "2>&1 >/dev/null | true", "2>&- | cat"}) {
        CAPTURE(streams);
        CHECK(shell(line, streams).code == 0);
        CHECK(is_whole(target));
    }
    for (const auto* streams : {">/dev/full", ">&-"}) {
        CAPTURE(streams);
        const auto outcome = shell(line, streams);
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "error: cannot write to standard output: "));
        CHECK(has(outcome.text, *streams == '>' && streams[1] == '/' ? "No space left on device" : "Bad file"));
        CHECK(is_whole(target));
        CHECK(shell("--help", streams).code == 5);
        CHECK(shell("check " + two_blocks, streams).code == 5);
    }
    // Nobody reads: the text is lost, the code says so, the results are there.
    const auto unread = shell(line, "| true");
    CHECK(is_whole(target));
    CHECK(has(unread.text, "cannot write to standard output: Broken pipe"));
    CHECK(shell(line, ">&- 2>&-").code == 5);
    CHECK(is_whole(target));
}

TEST_CASE("a terminal that closes and a broken pipe keep the results so far, as a polite kill does")
{
    const auto stopped = [](const std::string& before, const std::string& signals) {
        const ScratchFolder folder;
        const auto target = folder.path / "result";
        const auto line = fmt::format("run {} -o {} --checkpoint step --set 'operation.0.duration=100 h' "
                                      "--set 'numerics.max_step=1 s'",
                                      two_blocks, target.string());
        const auto script = folder.file(
            "stop", fmt::format("#!/bin/sh\n{} \"$@\" &\nprogram=$!\nwhile [ ! -e {}.checkpoint ]; do sleep 0.02; "
                                "done\nfor s in {}; do kill -$s $program; done\nwait $program\n",
                                before, target.string(), signals));
        fs::permissions(script, fs::perms::owner_all);
        const auto outcome = run("timeout -s KILL 60 " + script.string(), line);
        CHECK(has(content(target / "summary.json"), "\"interrupted\": true"));
        return outcome.code;
    };
    CHECK(stopped("", "HUP") == 130);
    CHECK(stopped("", "HUP HUP CONT") == 130);  // as some terminals do
    CHECK(stopped("", "PIPE") == 130);
    CHECK(stopped("nohup", "HUP HUP TERM") == 130);
}

TEST_CASE("a file that is too large for its limit is an error, not the end of the process")
{
    const ScratchFolder folder;
    const auto result = folder.path / "result", page = folder.path / "page.html";
    REQUIRE(run("", run_into(result)).code == 0);
    // Blocks of 512 bytes: 100 kB, the page has more. Without MPI, whose files have more too.
    const auto outcome = run("ulimit -f 200; ", fmt::format("report {} -o {}", result.string(), page.string()));
    CHECK(outcome.code == 5);
    CHECK(has(outcome.text, "page.html': File too large"));
    CHECK(names_in(folder.path).size() == 1);
}

TEST_CASE("a pipe in place of a result's file is refused, not waited for")
{
    const ScratchFolder folder;
    REQUIRE(run("", run_into(folder.path / "first")).code == 0);
    fs::remove(folder.path / "first/state.bin");
    REQUIRE(mkfifo((folder.path / "first/state.bin").c_str(), 0600) == 0);
    const auto outcome = run("timeout -s KILL 120",
                             run_into(folder.path / "second", fmt::format("--from {}/first", folder.path.string())));
    CHECK(outcome.code == 5);
    CHECK(has(outcome.text, "state.bin"));
    CHECK(has(outcome.text, "not a regular file"));
}
