/// Requirement: what other people's code does in a child process cannot harm this one.
#include "deadpoint/core/child_process.hpp"
#include "deadpoint/core/error.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <limits>
#include <new>
#include <stdexcept>
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
          "part 'a': reading 'a.step' failed: odd line 3\n  help: check the file with the program that wrote it");
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
