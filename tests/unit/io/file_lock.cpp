#include "deadpoint/io/file_lock.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/core/names/unique_name.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/rename.hpp"
#include "deadpoint/io/write_file.hpp"

#include <csignal>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

bool is_free(const fs::path& lock)
{
    try {
        const FileLock taken(lock, "it is taken");
        return true;
    } catch (const IoError&) {
        return false;
    }
}

}  // namespace

TEST_CASE("a lock keeps others out, says who holds it, and goes with its holder")
{
    const ScratchFolder folder;
    const auto file = folder.path / "results.lock";
    {
        const FileLock lock(file, "'results' is being written");
        CHECK(lock.held());
        std::string message;
        try {
            const FileLock second(file, "'results' is being written");
        } catch (const IoError& error) {
            message = error.what();
        }
        CHECK(message.find(fmt::format("'results' is being written by process {} on ", getpid())) == 0);
        CHECK(message.find(" since 20") != std::string::npos);
        CHECK(message.find("help: ") != std::string::npos);
        CHECK(fs::exists(file));
    }
    CHECK_FALSE(fs::exists(file));
    CHECK(is_free(file));
}

TEST_CASE("a lock outlives neither a killed process nor is it lifted by a child of its holder")
{
    const ScratchFolder folder;
    const auto file = folder.path / "lock";
    const pid_t holder = fork();
    if (holder == 0) {
        const FileLock lock(file, "");
        folder.file("taken", "x");
        pause();
        _exit(0);
    }
    while (!fs::exists(folder.path / "taken"))
        usleep(1000);
    CHECK_FALSE(is_free(file));
    kill(holder, SIGKILL);
    waitpid(holder, nullptr, 0);
    CHECK(fs::exists(file));  // left behind, and nobody's
    CHECK(is_free(file));

    auto lock = std::make_unique<FileLock>(file, "");
    if (const pid_t child = fork(); child == 0) {
        lock.reset();
        _exit(0);
    } else
        waitpid(child, nullptr, 0);
    CHECK(fs::exists(file));
    CHECK_FALSE(is_free(file));
}

TEST_CASE("a file of the user is never taken for a lock")
{
    const ScratchFolder folder;
    const auto file = folder.file("results.lock", "my notes");
    CHECK_FALSE(is_free(file));
    CHECK(content(file) == "my notes");
    fs::create_symlink(folder.path / "elsewhere", folder.path / "link");
    CHECK_FALSE(is_free(folder.path / "link"));
    CHECK_FALSE(fs::exists(folder.path / "elsewhere"));
}

TEST_CASE("a name that is taken is not taken away")
{
    const ScratchFolder folder;
    const auto a = folder.file("a", "a"), b = folder.file("b", "b");
    CHECK(rename_to_new(a, b) == std::errc::file_exists);
    CHECK(content(b) == "b");
    CHECK_FALSE(exchange_names(a, b));
    CHECK(content(b) == "a");
    CHECK_FALSE(rename_to_new(a, folder.path / "c"));
    CHECK(content(folder.path / "c") == "b");
    CHECK(rename_to_new(folder.path / "none", folder.path / "d") == std::errc::no_such_file_or_directory);
    CHECK_THROWS_AS(write_file(b, "new", IfThere::refuse), IoError);
    CHECK(content(b) == "a");
    write_file(folder.path / "d", "new", IfThere::refuse);
    CHECK(content(folder.path / "d") == "new");
}

TEST_CASE("unique names differ and are known again")
{
    const auto a = unique_name("results.partial-"), b = unique_name("results.partial-");
    CHECK(a != b);
    CHECK(is_unique_name(a, "results.partial-"));
    CHECK_FALSE(is_unique_name(a, "results.part-"));
    CHECK_FALSE(is_unique_name("results.partial-of mine", "results.partial-"));
    CHECK_FALSE(is_unique_name("results.partial-", "results.partial-"));
}
