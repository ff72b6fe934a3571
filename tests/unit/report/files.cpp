#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/file_lock.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <unistd.h>

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

constexpr auto replace = ResultFolder::IfExists::replace;

/// A result that holds one file, of which the text is its name.
void finish(const fs::path& target, const std::string& name,
            ResultFolder::IfExists if_exists = ResultFolder::IfExists::refuse)
{
    ResultFolder results(FolderClaim{target}, if_exists);
    put(results.path() / name, name);
    results.commit();
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

TEST_CASE("CSV: what a spreadsheet would compute is text; numbers with their units stay")
{
    const Folder folder;
    const std::vector<CsvColumn> columns{
        {"=A1", "",
         std::vector<std::string>{"=cmd|' /C calc'!A0", "+A1", "-2+3+cmd|' /C calc'!A0", "@SUM(1)", "-5 mm", "+1e-3 K",
                                  "-.5", "\x1b[31m", "two\nlines", "a-b"}}};
    write_csv(folder.path / "a.csv", std::vector<std::string>{"=1", "a\x1b\nb = 1"}, columns);
    CHECK(content(folder.path / "a.csv") == "# =1\n# a\\u001b b = 1\n"
                                            "'=A1\n'=cmd|' /C calc'!A0\n'+A1\n'-2+3+cmd|' /C calc'!A0\n'@SUM(1)\n"
                                            "-5 mm\n+1e-3 K\n-.5\n\\u001b[31m\ntwo lines\na-b\n");
}

TEST_CASE("a result folder appears only when it is committed")
{
    const Folder folder;
    const auto target = folder.path / "deep" / "results";
    {
        ResultFolder results(FolderClaim{target});
        put(results.path() / "a.txt", "a");
        CHECK_FALSE(fs::exists(target));
        CHECK(results.path().filename().string().starts_with("results.partial-"));
        results.commit();
    }
    CHECK(content(target / "a.txt") == "a");
    {
        ResultFolder abandoned(FolderClaim{folder.path / "other"});
        put(abandoned.path() / "a.txt", "a");
    }
    CHECK(folder.entries() == 1);  // only "deep": the abandoned folder left nothing
}

TEST_CASE("a folder that is being written is not written by another run")
{
    const Folder folder;
    const auto target = folder.path / "results";
    const FolderClaim claim(target);
    const auto message = io_error([&] { const FolderClaim second(target.string() + "/"); });
    CHECK(message.find("results' is being written by process " + std::to_string(getpid())) != std::string::npos);
    CHECK(io_error([&] { const FolderClaim other(folder.path / "others"); }).empty());
}

TEST_CASE("an existing result folder is refused, or replaced only by complete results")
{
    const Folder folder;
    const auto target = folder.path / "results";
    finish(target, "old.txt");

    const auto message = io_error([&] { ResultFolder refused(FolderClaim{target}); });
    CHECK(message.find("exists already") != std::string::npos);
    CHECK(message.find("--force") != std::string::npos);
    {
        ResultFolder abandoned(FolderClaim{target}, replace);
        put(abandoned.path() / "new.txt", "new");
    }
    CHECK(content(target / "old.txt") == "old.txt");
    finish(target.string() + "/", "new.txt", replace);
    CHECK(content(target / "new.txt") == "new.txt");
    CHECK_FALSE(fs::exists(target / "old.txt"));
    CHECK(folder.entries() == 1);
    fs::create_directories(folder.path / "empty");
    finish(folder.path / "empty", "new.txt", replace);
    CHECK(fs::exists(folder.path / "empty/new.txt"));
    CHECK(folder.entries() == 2);
}

TEST_CASE("what deadpoint did not write is never replaced, whoever asks")
{
    const Folder folder;
    const auto target = folder.path / "results";
    const auto refused = [&](const std::vector<fs::path>& inputs = {}) {
        return io_error([&] { ResultFolder f(FolderClaim{target}, replace, inputs); });
    };
    fs::create_directories(target / "fields");
    put(target / "notes.txt", "mine");
    CHECK(refused().find("is not replaced: ") != std::string::npos);  // not of deadpoint at all
    fs::remove_all(target);

    finish(target, "case.toml");
    CHECK(refused({folder.path / "case.toml"}).empty());
    CHECK(refused({target / "case.toml"}).find("from which its results would be computed") != std::string::npos);
    fs::create_directory_symlink(target, folder.path / "link");
    CHECK(refused({folder.path / "link" / "case.toml"}).find("would be computed") != std::string::npos);

    fs::create_directories(target / "below");
    put(target / "below" / "notes.txt", "mine");
    CHECK(refused().find("notes.txt', which deadpoint did not write") != std::string::npos);
    fs::remove_all(target / "below");
    put(target / "case.toml", "edited");
    CHECK(refused().find("case.toml' was changed since deadpoint wrote it") != std::string::npos);
    CHECK(content(target / "case.toml") == "edited");
    put(target / "case.toml", "case.toml");
    CHECK(refused().empty());

    finish(folder.path / "study", "sweep.json");
    CHECK(io_error([&] { ResultFolder f(FolderClaim{folder.path / "study"}, replace); }).find("holds a study") !=
          std::string::npos);
}

TEST_CASE("a link to a folder of results is followed, and stays")
{
    const Folder folder;
    finish(folder.path / "results", "old.txt");
    fs::create_directory_symlink("results", folder.path / "link");
    finish(folder.path / "link", "new.txt", replace);
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(content(folder.path / "results/new.txt") == "new.txt");
    CHECK(folder.entries() == 2);
}

TEST_CASE("a result folder that cannot be is refused in words")
{
    const Folder folder;
    put(folder.path / "file", "x");
    CHECK(io_error([&] { ResultFolder f(FolderClaim{folder.path / "file"}); }).find("is not a folder") !=
          std::string::npos);
    CHECK(io_error([&] { ResultFolder f(FolderClaim{folder.path / "file" / "below"}); }).find("cannot create") !=
          std::string::npos);
    for (const auto* name : {".", "..", "/", "a/.."})
        CHECK(io_error([&] { FolderClaim f(name); }).find("no name for a new folder") != std::string::npos);
}

TEST_CASE("a target that appears during the run is not overwritten and the results are kept")
{
    const Folder folder;
    const auto target = folder.path / "results";
    for (const auto if_exists : {ResultFolder::IfExists::refuse, replace}) {
        ResultFolder results(FolderClaim{target}, if_exists);
        put(results.path() / "a.txt", "a");
        fs::create_directories(target);
        put(target / "notes.txt", "mine");
        const auto message = io_error([&] { results.commit(); });
        CHECK(message.find("the results are in '" + results.path().string() + "'") != std::string::npos);
        CHECK(results.path().filename().string().starts_with("results.kept-"));
        CHECK(content(results.path() / "a.txt") == "a");
        CHECK(content(target / "notes.txt") == "mine");
        fs::remove_all(target);
    }
    CHECK(folder.entries() == 2);
    const FolderClaim next(target);  // tidies, but not these
    CHECK(folder.entries() == 3);
}

TEST_CASE("what ended runs have left is tidied by the next, and nothing whole is lost")
{
    const Folder folder;
    const auto target = folder.path / "results";
    const auto beside = [&](const std::string& ending) { return fs::path(target.string() + ending); };
    finish(target, "old.txt");
    fs::create_directories(beside(".partial-00000000"));  // killed at once,
    fs::create_directories(beside(".partial-11111111"));  // while it wrote,
    mark_unfinished(beside(".partial-11111111"));
    put(beside(".partial-11111111") / "half.txt", "half");
    finish(beside(".partial-22222222"), "whole.txt");   // while it took its name,
    finish(beside(".replaced-33333333"), "older.txt");  // and while it removed what it had replaced
    put(beside(".checkpoint.part-44444444"), "half");
    fs::create_directories(beside(".partial-of mine"));  // of the user
    fs::create_directories(beside(".partial-55555555"));
    put(beside(".partial-55555555") / "notes.txt", "mine");

    FolderClaim claim(target);
    const auto notes = claim.take_notes();
    REQUIRE(notes.size() == 1);
    const auto at = notes.front().find(target.string() + ".kept-");
    REQUIRE(at != std::string::npos);
    const auto kept = notes.front().substr(at, notes.front().rfind('\'') - at);
    CHECK(content(fs::path(kept) / "whole.txt") == "whole.txt");
    CHECK(content(target / "old.txt") == "old.txt");
    CHECK(content(beside(".partial-55555555") / "notes.txt") == "mine");
    CHECK(folder.entries() == 5);  // results, its lock, the kept one, two of the user
}

TEST_CASE("a result that lost its name to a run that was killed gets it back")
{
    const Folder folder;
    const auto target = folder.path / "results";
    finish(target.string() + ".replaced-00000000", "old.txt");
    CHECK(FolderClaim(target).take_notes().size() == 1);
    CHECK(content(target / "old.txt") == "old.txt");
    CHECK(folder.entries() == 1);
}
