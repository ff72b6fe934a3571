/// Requirement: a run that is killed at any moment, loses its disk or is stopped goes on from its checkpoint to the
/// results that it would have had, and no file that was torn is ever taken for a whole one.
#include "command.hpp"

#include <chrono>
#include <doctest/doctest.h>
#include <map>
#include <optional>
#include <random>
#include <sstream>

namespace {

const std::string starter_with_fields =
    DEADPOINT_SOURCE_DIR "/cases/starter/case.toml --size 6 --set 'operation.0.duration=20 min' --set "
                         "'output.field_times=[\"5 min\"]' --set 'numerics.time_tolerance=0.05 K'";
const std::string long_rest = DEADPOINT_TEST_DATA "/cli/two-blocks.toml --set 'numerics.max_step=15 s'";

/// All files of a result without what times, memory and paths make of them.
std::map<std::string, std::string> results(const fs::path& folder)
{
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const auto name = fs::relative(entry.path(), folder).string();
        if (!entry.is_regular_file() || name == "report.html" || name == "deadpoint.json")  // made of the others
            continue;
        std::istringstream text(content(entry.path()));
        std::string kept;
        bool timings = false;
        for (std::string line; std::getline(text, line);) {
            timings = timings || line.find("\"timings_s\"") != std::string::npos;
            if (!timings && line.find("memory") == std::string::npos)
                kept += line + '\n';
            timings = timings && line.find('}') == std::string::npos;
        }
        all[name] = kept;
    }
    return all;
}

void check_same(const fs::path& folder, const std::map<std::string, std::string>& wanted)
{
    const auto found = results(folder);
    CHECK(found.size() == wanted.size());
    for (const auto& [name, text] : wanted) {
        CAPTURE(name);
        REQUIRE(found.contains(name));
        CHECK(found.at(name) == text);
    }
}

/// Where a run said that it starts [h]; nothing if it died before.
std::optional<double> start_of(const std::string& text)
{
    const auto at = text.find(", t = ");
    if (has(text, "continuing from") && at != std::string::npos)
        return std::stod(text.substr(at + 6));
    return has(text, "starting at the beginning") ? std::optional(0.0) : std::nullopt;
}

}  // namespace

TEST_CASE("killed at random moments and resumed each time, a run ends with the results of one that was left alone")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result", checkpoint = folder.path / "result.checkpoint";
    const auto line = fmt::format("run {} --checkpoint step -o {}", starter_with_fields, target.string());
    const auto begin = std::chrono::steady_clock::now();
    REQUIRE(run("", line).code == 0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    CHECK_FALSE(fs::exists(checkpoint));
    const auto wanted = results(target);
    REQUIRE(wanted.size() > 10);
    std::uintmax_t bytes = 0;
    for (const auto& [name, text] : wanted)
        bytes += text.size();

    std::mt19937 random(8);
    std::uniform_real_distribution<double> share(0, 1);
    fs::remove_all(target);
    int killed = 0;
    double reached = 0;
    for (int i = 0; i < kills(); ++i) {
        CAPTURE(i);
        // By what it has written, at every third kill, falls into files; by time, anywhere.
        const auto before =
            i % 3 == 0 ? short_disk(static_cast<long long>(2 * share(random) * static_cast<double>(bytes)), true)
                       : fmt::format("timeout -s KILL {:.3f}", 0.02 + share(random) * seconds);
        const auto outcome = run(before, line + " --resume");
        const double from = start_of(outcome.text).value_or(reached);
        CHECK(from >= reached);  // nothing is lost again
        reached = from;
        killed += outcome.code == 137 ? 1 : 0;
        if (fs::exists(target)) {
            check_same(target, wanted);
            fs::remove_all(target);
            fs::remove(checkpoint);
            reached = 0;
        } else
            CHECK(outcome.code == 137);
    }
    CHECK(killed > 0);
    MESSAGE(killed, " of ", kills(), " runs were killed");
    CHECK(run("", line + " --resume").code == 0);
    check_same(target, wanted);
    CHECK_FALSE(fs::exists(checkpoint));
    for (const auto& entry : fs::directory_iterator(folder.path)) {
        const auto name = entry.path().filename().string();
        CAPTURE(name);
        CHECK((name == "result" || name.starts_with("result.kept-")));
    }
}

TEST_CASE("a disk too full for a checkpoint is a warning, and the run goes on")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto outcome = run(failing(folder.path / "result.checkpoint", "write:0:28"),  // ENOSPC
                             fmt::format("run {} --checkpoint step -o {}", long_rest, target.string()));
    CHECK(outcome.code == 0);
    CHECK(has(outcome.text, "the run goes on without a new checkpoint: cannot write"));
    CHECK(has(outcome.text, "No space left on device"));
    CHECK(fs::exists(target / "summary.json"));
    CHECK_FALSE(fs::exists(folder.path / "result.checkpoint"));
}

TEST_CASE("a checkpoint is never lost or taken without being asked for")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result", checkpoint = folder.path / "result.checkpoint";
    const auto line = fmt::format("run {} --checkpoint step -o {}", long_rest, target.string());
    const auto nothing = run("", line + " --resume");
    CHECK(nothing.code == 0);
    CHECK(has(nothing.text, "there is no " + checkpoint.string() + ": starting at the beginning"));
    const auto wanted = results(target);
    fs::remove_all(target);

    CHECK(run(short_disk(200'000, true), line).code == 137);
    REQUIRE(fs::exists(checkpoint));
    const auto bytes = content(checkpoint);
    const auto plain = run("", line);
    CHECK(plain.code == 5);
    CHECK(has(plain.text, "result.checkpoint' is the checkpoint of a run that was stopped"));
    CHECK(has(plain.text, "--resume"));
    CHECK(content(checkpoint) == bytes);

    const auto other = run("", line + " --resume --set 'machine.ambient=25 degC'");
    CHECK(other.code == 2);
    CHECK(has(other.text, "is a checkpoint of another case"));
    const auto coarser = run("", line + " --resume --size 2");
    CHECK(coarser.code == 2);
    CHECK(has(coarser.text, "belongs to another mesh"));
    const auto refining = run("", line + " --resume --accuracy 0.5K");
    CHECK(refining.code == 2);
    CHECK(has(refining.text, "writes no checkpoints"));

    folder.file("result.checkpoint", bytes.substr(0, bytes.size() - 1));
    const auto torn = run("", line + " --resume");
    CHECK(torn.code == 5);
    CHECK(has(torn.text, "result.checkpoint' is broken: it is cut short"));
    CHECK(has(torn.text, "--force"));
    CHECK_FALSE(fs::exists(target));

    folder.file("result.checkpoint", bytes);
    const auto resumed = run("", line + " --resume");
    CHECK(resumed.code == 0);
    CHECK(start_of(resumed.text).value_or(0) > 0);
    check_same(target, wanted);
    CHECK_FALSE(fs::exists(checkpoint));

    folder.file("result.checkpoint", bytes);
    CHECK(run("", line + " --force").code == 0);
    check_same(target, wanted);
    CHECK_FALSE(fs::exists(checkpoint));
}

TEST_CASE("stopped politely, a run leaves results so far and a checkpoint, from which it replaces them")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto script =
        folder.file("stop-when", "#!/bin/sh\nfile=$1; shift\n\"$@\" &\nprogram=$!\nwhile [ ! -e \"$file\" ]; "
                                 "do sleep 0.02; done\nkill -TERM $program\nwait $program\n");
    fs::permissions(script, fs::perms::owner_all);
    const auto line = fmt::format("run {} --set 'numerics.max_step=2 s' -o {}",
                                  DEADPOINT_TEST_DATA "/cli/two-blocks.toml", target.string());
    const auto stopped =
        run(fmt::format("{} {}.checkpoint", script.string(), target.string()), line + " --checkpoint step");
    REQUIRE(stopped.code == 130);
    CHECK(has(content(target / "summary.json"), "\"interrupted\": true"));
    CHECK(has(stopped.text, "the same command with --resume continues from there"));
    const auto resumed = run("", line + " --resume --checkpoint 0");
    CHECK(resumed.code == 0);
    CHECK(has(resumed.text, "continuing from"));
    CHECK(has(content(target / "summary.json"), "\"interrupted\": false"));
    CHECK_FALSE(fs::exists(folder.path / "result.checkpoint"));
}

TEST_CASE("a run that was stopped may end earlier, after the time reached, and replaces its results")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto script =
        folder.file("stop-when", "#!/bin/sh\nfile=$1; shift\n\"$@\" &\nprogram=$!\nwhile [ ! -e \"$file\" ]; "
                                 "do sleep 0.02; done\nkill -TERM $program\nwait $program\n");
    fs::permissions(script, fs::perms::owner_all);
    const auto line = fmt::format("run {} --set 'numerics.max_step=2 s' --checkpoint step -o {}",
                                  DEADPOINT_TEST_DATA "/cli/two-blocks.toml", target.string());
    REQUIRE(run(fmt::format("{} {}.checkpoint", script.string(), target.string()),
                line + " --set 'operation.0.duration=10 h'")
                .code == 130);
    const auto stopped = content(target / "history.csv");
    const auto before = run("", line + " --resume --set 'operation.0.duration=1 s'");  // it was further already
    CHECK(before.code == 2);
    CHECK(has(before.text, "was reached by another operation"));
    CHECK(content(target / "history.csv") == stopped);
    const auto shorter = run("", line + " --resume --set 'operation.0.duration=30 min'");
    CHECK(shorter.code == 0);
    CHECK(has(shorter.text, "continuing from"));
    CHECK(has(content(target / "summary.json"), "\"interrupted\": false"));
    CHECK(has(content(target / "history.csv"), "\n1800,"));
    CHECK_FALSE(fs::exists(folder.path / "result.checkpoint"));
}

TEST_CASE("a file that only has the name of a checkpoint is never lost")
{
    const ScratchFolder folder;
    const auto mine = folder.file("result.checkpoint", "mine");
    const auto line = fmt::format("run {} -o {}", long_rest, (folder.path / "result").string());
    for (const char* flag : {"", " --force", " --resume"}) {
        CAPTURE(flag);
        CHECK(run("", line + flag).code == 5);
        CHECK(content(mine) == "mine");
        CHECK_FALSE(fs::exists(folder.path / "result"));
    }
}

TEST_CASE("--checkpoint takes a time, 0 or step")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run {} -o {} --checkpoint ", long_rest, (folder.path / "result").string());
    for (const auto* wrong : {"10", "'-1 min'", "steps", "'5 mm'"}) {
        CAPTURE(wrong);
        CHECK(run("", line + wrong).code == 2);
    }
    CHECK(run(short_disk(100'000, true), line + "0").code == 137);
    CHECK_FALSE(fs::exists(folder.path / "result.checkpoint"));
}

TEST_CASE("a finished run is prolonged in its folder, killed or not, and becomes the run over the whole time")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result", other = folder.path / "other";
    const auto of = [](const char* duration, int size = 6) {
        return fmt::format("run {}/cases/starter/case.toml --size {} --checkpoint step --set 'numerics.max_step=3 min' "
                           "--set 'operation.0.duration={}'",
                           DEADPOINT_SOURCE_DIR, size, duration);
    };
    const auto lasting = [&](const char* duration) { return fmt::format("{} -o {}", of(duration), target.string()); };
    REQUIRE(run("", fmt::format("{} -o {}", of("40 min"), other.string())).code == 0);
    REQUIRE(run("", lasting("20 min")).code == 0);
    const auto beginning = results(target);
    const auto unchanged = [&] { return results(target) == beginning; };

    const auto same = run("", lasting("20 min") + " --resume");
    CHECK(same.code == 2);
    CHECK(has(same.text, "ended at 0.33 h, and this operation ends at 0.33 h"));
    CHECK(has(same.text, "'operation.0.duration=\"0.666667 h\"'"));
    const auto changed = run("", lasting("40 min") + " --resume --set 'machine.ambient=25 degC'");
    CHECK(changed.code == 2);
    CHECK(has(changed.text, "checkpoint of another case"));
    const auto finer = run("", fmt::format("{} --resume -o {}", of("40 min", 5), target.string()));
    CHECK(finer.code == 2);
    CHECK(has(finer.text, "belongs to another mesh"));
    CHECK(run("", lasting("40 min")).code == 5);  // without --resume no folder is replaced
    CHECK(unchanged());

    // Killed when it has written half of the new results: the old ones stay, and the next run goes on from its own
    // state.
    const auto killed = run(short_disk(1'500'000, true), lasting("40 min") + " --resume");
    CHECK(killed.code == 137);
    CHECK(has(killed.text, "continuing from " + (target / "checkpoint.bin").string()));
    CHECK(unchanged());
    REQUIRE(run("", lasting("40 min") + " --resume").code == 0);
    CHECK_FALSE(fs::exists(folder.path / "result.checkpoint"));

    const auto whole = results(other), prolonged = results(target);
    for (const auto* name : {"history.csv", "causes.csv", "state.bin"}) {
        CAPTURE(name);
        REQUIRE(whole.contains(name));
        CHECK(prolonged.at(name) == whole.at(name));
    }
    CHECK(has(content(target / "case.toml"), "duration = \"2400 s\""));

    const auto bytes = content(target / "checkpoint.bin");
    folder.file("result/checkpoint.bin", bytes.substr(0, bytes.size() / 2));
    const auto torn = run("", lasting("60 min") + " --resume");
    CHECK(torn.code == 2);
    CHECK(has(torn.text, "checkpoint.bin"));
}

TEST_CASE("results without a checkpoint are not prolonged, and the answer says how to go on")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto line = fmt::format("run {} -o {}", long_rest, target.string());
    REQUIRE(run("", line + " --checkpoint 0").code == 0);
    CHECK_FALSE(fs::exists(target / "checkpoint.bin"));
    const auto outcome = run("", line + " --resume --set 'operation.0.duration=100 h'");
    CHECK(outcome.code == 2);
    CHECK(has(outcome.text, "holds results without a checkpoint"));
    CHECK(has(outcome.text, "--from " + target.string()));
}
