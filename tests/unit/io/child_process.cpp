/// Requirement: what other people's code does in a child process cannot harm this one, nor anything else.
#include "deadpoint/io/child_process.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>
#include <seccomp.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace deadpoint;

namespace {

constexpr ChildLimits roomy{std::size_t{1} << 30U, 60};

template <class Wanted>
std::string message_of(const ChildLimits& limits, const std::function<std::string()>& work)
{
    try {
        run_in_child("part 'a': reading 'a.step'", limits, work);
    } catch (const Wanted& error) {
        return error.what();
    }
    return "no such error";
}

}  // namespace

TEST_CASE("A child process hands over its bytes and changes nothing here")
{
    int here = 1;
    std::string wanted;
    for (int i = 0; i < 300000; ++i)  // more than a pipe holds
        wanted += static_cast<char>(i);
    const auto got = run_in_child("work", roomy, [&] {
        here = 2;
        return wanted;
    });
    CHECK(got == wanted);
    CHECK(here == 1);
    CHECK(run_in_child("work", roomy, [] { return std::string(); }).empty());
}

TEST_CASE("Errors of a child process come back as what they are")
{
    CHECK(message_of<InputError>(roomy, []() -> std::string { throw InputError("no solid"); }) == "no solid");
    CHECK(message_of<IoError>(roomy, []() -> std::string { throw IoError("no file"); }) == "no file");
    CHECK(message_of<InputError>(roomy, []() -> std::string { throw std::runtime_error("odd line 3"); }) ==
          "part 'a': reading 'a.step' failed: an error that the program does not know\n  help: check the file with the "
          "program that wrote it");
}

TEST_CASE("A child process that crashes, hangs or takes all memory becomes an error")
{
    const auto crash = message_of<InputError>(roomy, []() -> std::string { std::abort(); });
    CHECK(crash.starts_with("part 'a': reading 'a.step' failed: the reader crashed (signal 6, Aborted)"));

    const auto hang = message_of<InputError>({roomy.memory, 0.2}, []() -> std::string {
        for (volatile bool forever = true; forever;) {
        }
        return {};
    });
    CHECK(hang.starts_with("part 'a': reading 'a.step' took longer than 0.2 s and was stopped"));

    const auto glutton = message_of<InputError>({std::size_t{1} << 28U, 60}, []() -> std::string {
        std::vector<char> much(std::size_t{1} << 30U, 'x');
        return {much.begin(), much.begin() + 1};
    });
#ifdef __SANITIZE_ADDRESS__  // its operator new ends the process instead of throwing
    CHECK(glutton.starts_with("part 'a': reading 'a.step' failed: the reader ended without a result"));
#else
    CHECK(glutton.starts_with("part 'a': reading 'a.step' needs more than 0.3 GB of memory"));
#endif
}

TEST_CASE("A child process cannot write, start, remove, rename, kill or call anyone")
{
    const ScratchFolder folder;
    const std::string kept = folder.file("kept.txt", "kept");
    const std::string fresh = folder.path / "fresh.txt";
    struct Misdeed {
        const char* call;
        std::function<void()> deed;
    };
    const Misdeed misdeeds[] = {
        {"", [&] { std::ofstream(fresh) << "x"; }},
        {"", [&] { std::ofstream(kept) << "x"; }},
        {"", [&] { std::ofstream(kept, std::ios::app) << "x"; }},
        {"", [&] { [[maybe_unused]] const int file = creat(fresh.c_str(), 0600); }},
        {"to start a program", [&] { [[maybe_unused]] const int code = std::system(("touch " + fresh).c_str()); }},
        {"clone", [] { [[maybe_unused]] const auto child = fork(); }},
        {"execve", [&] { execl("/bin/touch", "touch", fresh.c_str(), nullptr); }},
        {"rename", [&] { std::rename(kept.c_str(), fresh.c_str()); }},
        {"mkdir", [&] { std::filesystem::create_directory(fresh); }},
        {"symlink", [&] { std::filesystem::create_symlink(kept, fresh); }},
        {"truncate", [&] { std::filesystem::resize_file(kept, 1); }},
        {"chmod", [&] { std::filesystem::permissions(kept, std::filesystem::perms::none); }},
        {"kill", [] { kill(getppid(), SIGTERM); }},
        {"socket", [] { [[maybe_unused]] const int s = socket(AF_INET, SOCK_STREAM, 0); }},
        {"a thread", [] { std::thread([] {}).join(); }},
        {"mmap", [] { mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0); }},
    };
    for (const auto& misdeed : misdeeds) {
        const auto said = message_of<InputError>(roomy, [&] {
            misdeed.deed();
            return std::string("done");
        });
        CHECK(said.starts_with("part 'a': reading 'a.step' was stopped: "));
        CHECK_MESSAGE(said.find(misdeed.call) != std::string::npos, said);
    }
    // Quietly refused, since libraries try it for files of their own.
    CHECK(run_in_child("work", roomy, [&] { return std::to_string(unlink(kept.c_str())); }) == "-1");
    CHECK(content(kept) == "kept");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("A child process reads its one file, under its name, and no other")
{
    const ScratchFolder folder;
    ChildLimits limits = roomy;
    limits.file = folder.file("of the user", "wanted");
    limits.name = "part.msh";
    const std::string secret = folder.file("secret.msh", "secret");
    const auto twice = run_in_child("work", limits, [] { return content("part.msh") + content("/any/part.msh"); });
    CHECK(twice == "wantedwanted");
    CHECK(message_of<InputError>(limits, [&] { return content(secret); }) ==
          fmt::format("part 'a': reading 'a.step' was stopped: it wants to open another file, '{}'\n  help: put all "
                      "into one file; do not use it if it is not yours and should need no other",
                      secret));
    // That a file is there stays unsaid; the system's own look as if missing.
    CHECK(run_in_child("work", limits, [&] { return std::to_string(std::filesystem::exists(secret)); }) == "0");
    CHECK(
        run_in_child("work", limits, [] { return content("/usr/share/locale/C/x.mo") + content("XSTEP.us"); }).empty());
    CHECK(message_of<InputError>(limits, [] { return content("/etc/passwd"); }).find("'/etc/passwd'") !=
          std::string::npos);
    CHECK(
        run_in_child("work", limits, [] { return std::string(std::getenv("HOME") == nullptr ? "" : "HOME"); }).empty());
    // What was open stays outside.
    const int open_here = open(secret.c_str(), O_RDONLY);
    REQUIRE(open_here >= 0);
    CHECK(run_in_child("work", limits, [&] {
              char byte = 0;
              return std::to_string(read(open_here, &byte, 1));
          }) == "-1");
    close(open_here);
    limits.file = folder.path / "missing";
    CHECK(message_of<IoError>(limits, [] { return std::string(); }).find("cannot be opened") != std::string::npos);
}

TEST_CASE("Where the kernel gives no filters, nothing is read, and the error says why")
{
    const pid_t elsewhere = fork();
    if (elsewhere == 0) {
        auto* filter = seccomp_init(SCMP_ACT_ALLOW);
        seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(seccomp), 0);
        seccomp_rule_add(filter, SCMP_ACT_ERRNO(EINVAL), SCMP_SYS(prctl), 1, SCMP_A0(SCMP_CMP_EQ, PR_SET_SECCOMP));
        seccomp_load(filter);
        const auto said = message_of<IoError>(roomy, [] { return std::string("read"); });
        _exit(said.starts_with("files of others are read only where the kernel can keep their reader from") ? 0 : 1);
    }
    int status = -1;
    REQUIRE(waitpid(elsewhere, &status, 0) == elsewhere);
    CHECK(status == 0);
}
