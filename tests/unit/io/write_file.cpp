#include "deadpoint/io/write_file.hpp"

#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

using namespace deadpoint;
namespace fs = std::filesystem;

TEST_CASE("a file is replaced only by a complete one")
{
    const fs::path folder = fs::temp_directory_path() / ("deadpoint-file-" + std::to_string(std::random_device{}()));
    fs::create_directories(folder);
    const auto content = [&] {
        std::ifstream in(folder / "a.txt");
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    write_file(folder / "a.txt", "first");
    CHECK(content() == "first");
    const auto broken = [](std::ostream& out) {
        out << "half";
        throw DomainError("stopped");
    };
    CHECK_THROWS_AS(write_file(folder / "a.txt", broken), DomainError);
    CHECK(content() == "first");
    write_file(folder / "a.txt", [](std::ostream& out) { out << "second"; });
    CHECK(content() == "second");
    write_file(
        folder / "a.txt", [](std::ostream& out) { out << "third"; }, Durability::synced);
    CHECK(content() == "third");
    CHECK(sync_to_disk(folder));
    CHECK_FALSE(sync_to_disk(folder / "none"));
    CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}) == 1);  // nothing half left behind

    CHECK_THROWS_AS(write_file(folder / "no/such/folder/a.txt", "text"), IoError);
    fs::create_directories(folder / "taken");
    CHECK_THROWS_AS(write_file(folder / "taken", "text"), IoError);
    fs::remove_all(folder);
}
