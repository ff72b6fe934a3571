#include "../scratch_folder.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/report/csv.hpp"
#include "deadpoint/report/json_file.hpp"
#include "deadpoint/report/result_folder.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace deadpoint;
using namespace deadpoint::report;
namespace fs = std::filesystem;

namespace {

struct Folder : ScratchFolder {
    [[nodiscard]] std::size_t entries() const
    {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator{}));
    }
};

void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

/// What an IoError says, or nothing if there was none.
template <class F>
std::string io_error(F&& action)
{
    try {
        action();
    } catch (const IoError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("CSV: comments, units in the header, quoting, empty cell for what is not finite")
{
    const Folder folder;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<CsvColumn> columns{{"time", "s", std::vector<double>{0, 60.5}},
                                         {"A", "K", std::vector<double>{1.0 / 3.0, nan}},
                                         {"name, or \"alias\"", "", std::vector<std::string>{"plain", "a,b"}}};
    write_csv(folder.path / "a.csv", std::vector<std::string>{"deadpoint 1", "two\nlines"}, columns);
    CHECK(content(folder.path / "a.csv") == "# deadpoint 1\n# two lines\n"
                                            "time [s],A [K],\"name, or \"\"alias\"\"\"\n"
                                            "0,0.333333333,plain\n"
                                            "60.5,,\"a,b\"\n");
    const std::vector<CsvColumn> ragged{{"a", "", std::vector<double>{1, 2}}, {"b", "", std::vector<double>{1}}};
    CHECK_THROWS_AS(write_csv(folder.path / "b.csv", {}, ragged), InputError);
    CHECK_THROWS_AS(write_csv(folder.path / "missing" / "b.csv", {}, columns), IoError);
}

TEST_CASE("JSON keeps the order of its keys and turns what is not finite into null")
{
    const Folder folder;
    nlohmann::ordered_json document;
    document["z"] = 1;
    document["a"] = std::numeric_limits<double>::infinity();
    document["text"] = "broken \xff byte";
    write_json(folder.path / "a.json", document);
    const auto text = content(folder.path / "a.json");
    CHECK(text.find("{\n  \"z\": 1,\n  \"a\": null,\n") == 0);
    CHECK(nlohmann::json::parse(text)["z"] == 1);
}

TEST_CASE("a result folder appears only when it is committed")
{
    const Folder folder;
    const auto target = folder.path / "deep" / "results";
    {
        ResultFolder results(target);
        put(results.path() / "a.txt", "a");
        CHECK_FALSE(fs::exists(target));
        CHECK(results.path().filename().string().starts_with("results.partial-"));
        results.commit();
    }
    CHECK(content(target / "a.txt") == "a");
    {
        ResultFolder abandoned(folder.path / "other");
        put(abandoned.path() / "a.txt", "a");
    }
    CHECK(folder.entries() == 1);  // only "deep": the abandoned folder left nothing
}

TEST_CASE("an existing result folder is refused, or replaced only by complete results")
{
    const Folder folder;
    const auto target = folder.path / "results";
    fs::create_directories(target);
    put(target / "old.txt", "old");

    const auto message = io_error([&] { ResultFolder refused(target); });
    CHECK(message.find("exists already") != std::string::npos);
    CHECK(message.find("--force") != std::string::npos);
    {
        ResultFolder abandoned(target, ResultFolder::IfExists::replace);
        put(abandoned.path() / "new.txt", "new");
    }
    CHECK(content(target / "old.txt") == "old");
    ResultFolder results(target.string() + "/", ResultFolder::IfExists::replace);
    put(results.path() / "new.txt", "new");
    results.commit();
    CHECK(content(target / "new.txt") == "new");
    CHECK_FALSE(fs::exists(target / "old.txt"));
    CHECK(folder.entries() == 1);
}

TEST_CASE("a result folder that cannot be is refused in words")
{
    const Folder folder;
    put(folder.path / "file", "x");
    CHECK(io_error([&] { ResultFolder f(folder.path / "file"); }).find("is not a folder") != std::string::npos);
    CHECK(io_error([&] { ResultFolder f(folder.path / "file" / "below"); }).find("cannot create") != std::string::npos);
    CHECK(io_error([&] { ResultFolder f("."); }).find("no name for a new folder") != std::string::npos);
}

TEST_CASE("a target that appears during the run is not overwritten and the results are kept")
{
    const Folder folder;
    const auto target = folder.path / "results";
    fs::path partial;
    {
        ResultFolder results(target);
        partial = results.path();
        put(partial / "a.txt", "a");
        fs::create_directories(target);
        CHECK_THROWS_AS(results.commit(), IoError);
    }
    CHECK(content(partial / "a.txt") == "a");
    CHECK(fs::is_empty(target));
}
