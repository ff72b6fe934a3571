#include "deadpoint/io/plain_reason.hpp"

#include <doctest/doctest.h>
#include <stdexcept>
#include <string>

using deadpoint::plain_reason;

TEST_CASE("a reason is that of deadpoint or of the system, never the text of the C++ library")
{
    CHECK(plain_reason(deadpoint::InputError("wrong\n  help: right")) == "wrong\n  help: right");
    CHECK(plain_reason(std::bad_alloc()) == "memory ran out");
    CHECK(plain_reason(std::bad_array_new_length()) == "memory ran out");
    const auto missing = std::make_error_code(std::errc::no_such_file_or_directory);
    CHECK(plain_reason(std::filesystem::filesystem_error("cannot open", "a/b", missing)) ==
          "'a/b': No such file or directory");
    CHECK(plain_reason(std::filesystem::filesystem_error("cannot open", missing)) == "No such file or directory");
    CHECK(plain_reason(std::system_error(missing, "what")) == "No such file or directory");
    const auto thrown = [](const auto& work) {
        try {
            work();
        } catch (const std::exception& error) {
            return plain_reason(error);
        }
        return std::string();
    };
    CHECK(thrown([] { (void)std::stoi("x"); }) == "an error that the program does not know");
    CHECK(thrown([] { (void)std::string("a").at(2); }) == "an error that the program does not know");
}
