#include "../scratch_folder.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/core/read_file.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

TEST_CASE("a file is read whole, byte for byte; where there is none there is nothing")
{
    const ScratchFolder folder;
    const std::string bytes("a\r\n\0\xff", 5);
    const auto file = folder.file("a", bytes);
    CHECK(read_file(file, 5) == bytes);
    CHECK(read_file(folder.file("empty", ""), 5) == std::string());
    CHECK_FALSE(read_file(folder.path / "none", 5).has_value());
}

TEST_CASE("a file that is too large, or no file, is refused before it is read")
{
    const ScratchFolder folder;
    const auto file = folder.file("a", "123456");
    CHECK_THROWS_WITH_AS((void)read_file(file, 5), doctest::Contains("larger than"), InputError);
    // A hole takes no room on the disk.
    std::filesystem::resize_file(file, largest_result + 1);
    CHECK_THROWS_WITH_AS((void)read_file(file, largest_result), doctest::Contains("256 MiB"), InputError);
    CHECK_THROWS_WITH_AS((void)read_file(folder.path, 5), doctest::Contains("check that it is a file"), IoError);
    CHECK_THROWS_AS((void)read_file("/dev/zero", 5), IoError);
}
