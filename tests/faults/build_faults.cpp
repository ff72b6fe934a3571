/// Requirement: a build of a reduced press that is killed at any moment, or stopped, goes on from its checkpoint to the
/// files that it would have written, and takes no checkpoint of another build.
#include "command.hpp"

#include <chrono>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <iterator>
#include <random>
#include <string>

namespace {

const std::string blocks = DEADPOINT_TEST_DATA "/cli/two-blocks.toml";

struct Build {
    const ScratchFolder folder;
    fs::path file = folder.path / "press.rom", large = folder.path / "press.large.rom";
    fs::path checkpoint = folder.path / "press.rom.checkpoint";
    std::string line = fmt::format("reduce {} -o {}", blocks, file.string());
    [[nodiscard]] std::string result() const { return content(file) + content(large); }
};

}  // namespace

TEST_CASE("killed at random moments and resumed each time, a build ends with the files of one that was left alone")
{
    const Build build;
    const auto begin = std::chrono::steady_clock::now();
    REQUIRE(run("", build.line).code == 0);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    CHECK_FALSE(fs::exists(build.checkpoint));
    const auto wanted = build.result();

    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    int killed = 0, went_on = 0;
    for (int i = 0; i < kills(); ++i) {
        CAPTURE(i);
        // By what it has written, at every third kill, falls into files; by time, anywhere.
        const auto before = i % 3 == 0 ? short_disk(static_cast<long long>(share(random) * 4e5), true)
                                       : fmt::format("timeout -s KILL {:.3f}", 0.02 + share(random) * seconds);
        const auto outcome = run(before, build.line + " --resume");
        killed += outcome.code == 137 ? 1 : 0;
        went_on += has(outcome.text, "continuing from") ? 1 : 0;
        if (outcome.code == 0)
            CHECK(build.result() == wanted);
        else
            CHECK(outcome.code == 137);
    }
    CHECK(killed > 0);
    CHECK(went_on > 0);
    REQUIRE(run("", build.line + " --resume").code == 0);
    CHECK(build.result() == wanted);
    CHECK_FALSE(fs::exists(build.checkpoint));
}

TEST_CASE("killed while it removes its checkpoint, a build has its files, and the next one begins anew")
{
    const Build build;
    REQUIRE(run(failing(build.checkpoint, "unlinkat:2:kill"), build.line).code == 137);
    CHECK(fs::exists(build.file));
    const auto wanted = build.result();
    const auto next = run("", build.line + " --resume");
    CHECK(next.code == 0);
    CHECK(has(next.text, "starting at the beginning"));
    CHECK(build.result() == wanted);
    const auto leftovers = std::distance(fs::directory_iterator(build.folder.path), fs::directory_iterator());
    CHECK(leftovers == 2);  // the two files of the press
}

TEST_CASE("a stopped build keeps what it has, says how to go on, and is not lost or taken unasked")
{
    const Build build;
    const auto script =
        build.folder.file("stop-when", "#!/bin/sh\nfile=$1; shift\n\"$@\" &\nprogram=$!\nwhile [ ! -e \"$file\" ]; "
                                       "do sleep 0.002; done\nkill -TERM $program\nwait $program\n");
    fs::permissions(script, fs::perms::owner_all);
    const auto stopped =
        run(fmt::format("{} {}", script.string(), (build.checkpoint / "fields-002.bin").string()), build.line);
    REQUIRE(stopped.code == 130);
    CHECK(has(stopped.text, "the same command with --resume continues from there"));
    CHECK_FALSE(fs::exists(build.file));
    REQUIRE(fs::exists(build.checkpoint / "fields-002.bin"));
    CHECK_FALSE(fs::exists(build.checkpoint / "training.bin"));

    const auto plain = run("", build.line);
    CHECK(plain.code == 5);
    CHECK(has(plain.text, "press.rom.checkpoint' is the checkpoint of a build that was stopped"));
    const auto other = run("", build.line + " --resume --set 'machine.ambient=25 degC'");
    CHECK(other.code == 2);
    CHECK(has(other.text, "belongs to another build"));
    const auto coarser = run("", build.line + " --resume --size 2");
    CHECK(coarser.code == 2);
    CHECK(has(coarser.text, "belongs to another build"));
    const auto piece = build.checkpoint / "fields-001.bin";
    const auto bytes = content(piece);
    fs::resize_file(piece, bytes.size() - 1);
    const auto torn = run("", build.line + " --resume");
    CHECK(torn.code == 5);
    CHECK(has(torn.text, "fields-001.bin' is broken: it is cut short"));
    build.folder.file("press.rom.checkpoint/fields-001.bin", bytes);

    CHECK(run("", build.line + " --resume").code == 0);
    CHECK_FALSE(fs::exists(build.checkpoint));
    CHECK(fs::exists(build.file));
    const auto nothing = run("", build.line + " --resume");
    CHECK(nothing.code == 0);
    CHECK(has(nothing.text, "there is no " + build.checkpoint.string() + ": starting at the beginning"));
}

TEST_CASE("a disk too full for a piece of a build is a warning, and the build goes on")
{
    const Build build;
    const auto outcome = run(failing(build.checkpoint / "training.bin", "write:0:28"), build.line);  // ENOSPC
    CHECK(outcome.code == 0);
    CHECK(has(outcome.text, "the build goes on without keeping 'training': cannot write"));
    CHECK(fs::exists(build.file));
}

TEST_CASE("a build replaces a reduced press only if asked, and other files never")
{
    const Build build;
    REQUIRE(run("", build.line).code == 0);
    const auto wanted = build.result();
    const auto plain = run("", build.line);
    CHECK(plain.code == 5);
    CHECK(has(plain.text, "press.rom' exists already"));
    CHECK(build.result() == wanted);
    CHECK(run("", build.line + " --force").code == 0);
    CHECK(build.result() == wanted);
    for (const char* name : {"press.rom", "press.large.rom"}) {
        CAPTURE(name);
        const auto bytes = content(build.folder.path / name);
        (void)build.folder.file(name, "mine");
        const auto foreign = run("", build.line + " --force");
        CHECK(foreign.code == 5);
        CHECK(has(foreign.text, fmt::format("{}' exists, and is no file of a reduced press", name)));
        CHECK(content(build.folder.path / name) == "mine");
        (void)build.folder.file(name, bytes);
    }
    fs::create_directories(build.checkpoint);
    (void)build.folder.file("press.rom.checkpoint/mine.txt", "mine");
    CHECK(run("", build.line + " --force").code == 5);
    CHECK(content(build.checkpoint / "mine.txt") == "mine");
}
