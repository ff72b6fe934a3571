#include "deadpoint/io/read_file.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

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

TEST_CASE("a file whose bytes cannot be read, or are more than its size, is an error and never a shorter file")
{
    // Reading the first page of one's own memory fails with EIO, though the file can be opened and is regular.
    CHECK_THROWS_WITH_AS((void)read_file("/proc/self/mem", 5), doctest::Contains("Input/output error after 0"),
                         IoError);
    // The kernel states a size of 0 for a file that it fills when it is read.
    CHECK_THROWS_WITH_AS((void)read_file("/proc/self/status", 5), doctest::Contains("bytes came of 0"), IoError);
    CHECK_THROWS_AS((void)read_pieces("/proc/self/mem", [](std::string_view) {}), IoError);
}

TEST_CASE("a pipe is refused at once instead of waited for")
{
    const ScratchFolder folder;
    const auto pipe = folder.path / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    CHECK_THROWS_WITH_AS((void)read_file(pipe, 5), doctest::Contains("not a regular file"), IoError);
}

TEST_CASE("pieces of a file are all of it")
{
    const ScratchFolder folder;
    std::string bytes(2'500'000, ' ');
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<char>(i % 251);
    std::string seen;
    CHECK(read_pieces(folder.file("a", bytes), [&](std::string_view piece) { seen += piece; }) == bytes.size());
    CHECK(seen == bytes);
}
