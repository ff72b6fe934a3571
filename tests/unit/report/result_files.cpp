/// Requirement: a reader takes a file of a result folder only as it was written there, by that run.
#include "deadpoint/report/folder/result_files.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace deadpoint;
using namespace deadpoint::report;
namespace fs = std::filesystem;

namespace {

/// A folder as a run leaves it, with a folder of fields below.
struct Folder : ScratchFolder {
    Folder()
    {
        (void)file("a.csv", "time [s]\n0\n1\n");
        fs::create_directory(path / "fields");
        (void)file("fields/b.vtu", std::string(3'000'000, 'x'));
        write_manifest(path);
    }
};

}  // namespace

TEST_CASE("files as they were written are handed out; those that never were are nothing")
{
    const Folder folder;
    const ResultFiles files(folder.path);
    CHECK(files.listed().size() == 2);
    CHECK(files.read("a.csv") == "time [s]\n0\n1\n");
    CHECK_FALSE(files.read("none.csv").has_value());
    CHECK(files.listed().at("fields/b.vtu").size == 3'000'000);
    CHECK_NOTHROW(files.check("fields/b.vtu"));
    const auto list = nlohmann::json::parse(content(folder.path / manifest_name));
    CHECK(list["format"] == result_format);
    CHECK(list["written_by"] == "deadpoint");
}

TEST_CASE("a file that was cut, changed by a bit, lost or put there is refused by name")
{
    const Folder folder;
    const ResultFiles files(folder.path);
    (void)folder.file("a.csv", "time [s]\n0\n");
    CHECK_THROWS_WITH_AS((void)files.read("a.csv"), doctest::Contains("it has 11 bytes, written were 13"), InputError);
    (void)folder.file("a.csv", "time [s]\n0\n3\n");
    CHECK_THROWS_WITH_AS((void)files.read("a.csv"), doctest::Contains("checksum does not fit"), InputError);
    CHECK_THROWS_WITH_AS((void)files.read("a.csv"), doctest::Contains("a.csv' was changed"), InputError);
    fs::remove(folder.path / "a.csv");
    CHECK_THROWS_WITH_AS((void)files.read("a.csv"), doctest::Contains("a.csv' is missing"), IoError);
    (void)folder.file("loads.json", "{}");
    CHECK_THROWS_WITH_AS((void)files.read("loads.json"), doctest::Contains("does not belong to these results"),
                         InputError);
    auto bytes = content(folder.path / "fields/b.vtu");
    bytes[2'000'000] ^= 1;
    (void)folder.file("fields/b.vtu", bytes);
    CHECK_THROWS_WITH_AS(files.check("fields/b.vtu"), doctest::Contains("checksum does not fit"), InputError);
}

TEST_CASE("files of two runs do not go together, whichever list stands beside them")
{
    const Folder one, other;
    (void)other.file("a.csv", "time [s]\n0\n2\n");
    write_manifest(other.path);
    for (const char* moved : {"a.csv", manifest_name}) {
        CAPTURE(moved);
        const Folder mixed;
        fs::copy_file(other.path / moved, mixed.path / moved, fs::copy_options::overwrite_existing);
        const ResultFiles files(mixed.path);
        CHECK_THROWS_WITH_AS((void)files.read("a.csv"), doctest::Contains("was changed"), InputError);
    }
}

TEST_CASE("a list that is missing, broken, changed or of another format is refused with the remedy")
{
    const Folder folder;
    const auto list = content(folder.path / manifest_name);
    const auto refused = [&](const std::string& text, const char* what) {
        (void)folder.file(manifest_name, text);
        CHECK_THROWS_WITH_AS(ResultFiles(folder.path), doctest::Contains(what), InputError);
    };
    auto changed = list;
    changed.replace(changed.find("\"bytes\": 13"), 11, "\"bytes\": 11");
    refused(changed, "deadpoint.json' was changed");
    auto next = list;
    next.replace(next.find("\"format\": 2"), 11, "\"format\": 3");
    refused(next, "is of format 3");
    refused(list.substr(0, list.size() / 2), "not the JSON");
    refused("{}", "was changed");
    refused("3", "was changed");
    fs::remove(folder.path / manifest_name);
    CHECK_THROWS_WITH_AS(ResultFiles(folder.path), doctest::Contains("results of older versions"), InputError);
    CHECK_THROWS_WITH_AS(ResultFiles(folder.path / "none"), doctest::Contains("there is no folder"), IoError);
}

TEST_CASE("a file written anew is listed as it is then; folders without a list get none")
{
    const Folder folder;
    record_file(folder.file("a.csv", "new"));
    record_file(folder.file("report.html", "<p>"));
    const ResultFiles files(folder.path);
    CHECK(files.read("a.csv") == "new");
    CHECK(files.read("report.html") == "<p>");
    const ScratchFolder bare;
    record_file(bare.file("a.csv", "new"));
    CHECK_FALSE(fs::exists(bare.path / manifest_name));
}

TEST_CASE("what deadpoint did not write is named, in folders below too, whose own lists count")
{
    const Folder folder;
    CHECK(foreign_files(folder.path).empty());
    fs::create_directories(folder.path / "points/one");
    (void)folder.file("points/one/c.csv", "c");
    CHECK(foreign_files(folder.path) == std::vector<fs::path>{folder.path / "points/one/c.csv"});
    write_manifest(folder.path / "points/one");
    CHECK(foreign_files(folder.path).empty());
    (void)folder.file("points/one/notes.txt", "mine");
    CHECK(foreign_files(folder.path) == std::vector<fs::path>{folder.path / "points/one/notes.txt"});
    write_manifest(folder.path);  // which leaves the folder with a list of its own alone
    CHECK(foreign_files(folder.path).size() == 1);
}
