/// Requirement: the table of a study's points has a whole row for each point that ended, whenever the study is stopped,
/// and gives back what tables and charts need.
#include "deadpoint/report/folder/point_table.hpp"

#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"
#include "everything.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::report;
using namespace everything;
using State = twin::PointOutcome::State;

namespace {

press::RunRecord long_record()
{
    auto run = record();
    run.time = {0, 1800, 3600};
    run.rises["top"] = {0, 3, 2};
    run.chain["E_SW"] = {0, -1.5e-5, 1e-5};
    run.joint_heat = {{"pin", {100, 90, 80}}, {"guide", {10, 9, 8}}};
    return run;
}

PointRow done(const std::string& name)
{
    return {name, "mark of " + name, {State::done, {}, 0.25}, brief(long_record())};
}

}  // namespace

TEST_CASE("a brief record has the figures of the whole one")
{
    const auto whole = sweep_figures(long_record()), found = sweep_figures(brief(long_record()));
    CHECK(found.drift->largest == whole.drift->largest);
    CHECK(found.drift->largest_time == 1800);
    CHECK(found.drift->final == whole.drift->final);
    CHECK(found.drift->gap->steady_from == whole.drift->gap->steady_from);
    CHECK(found.rises == whole.rises);
    CHECK(*found.joint_heat == 88);
    CHECK(found.bearing_forces == whole.bearing_forces);
    CHECK(brief(long_record()).time.size() == 2);
}

TEST_CASE("rows come back as they were written, those before the first result too")
{
    const ScratchFolder folder;
    const auto file = folder.path / "points.csv";
    PointTable table(file, "study");
    table.add({"first", "mark of first", {State::failed, "no, \"never\"", 1}, {}});
    CHECK(!std::filesystem::exists(file));  // its columns are not known yet
    table.add(done("second"));
    table.add(done("third"));
    const auto rows = read_points(file, "study");  // the table is still being written
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].point == "first");
    CHECK(rows[0].outcome.state == State::failed);
    CHECK(rows[0].outcome.reason == "no, \"never\"");
    CHECK(!rows[0].record);
    CHECK(rows[2].mark == "mark of third");
    CHECK(rows[2].outcome.seconds == 0.25);
    REQUIRE(rows[2].record);
    CHECK(rows[2].record->hash == record().hash);
    const auto found = sweep_figures(*rows[2].record), wanted = sweep_figures(long_record());
    CHECK(found.drift->largest == near(wanted.drift->largest, 1e-8));  // nine digits
    CHECK(found.drift->largest_time == 1800);
    CHECK(found.drift->final == near(wanted.drift->final, 1e-8));
    CHECK(found.drift->gap->range == near(wanted.drift->gap->range, 1e-8));
    CHECK(found.rises == wanted.rises);
    CHECK(found.joint_heat == wanted.joint_heat);
    CHECK(found.bearing_forces == wanted.bearing_forces);
}

TEST_CASE("a table goes on after known rows, and can be put into order")
{
    const ScratchFolder folder;
    const auto file = folder.path / "points.csv";
    const PointRow failed{"second", "mark", {State::failed, "why", 1}, {}};
    PointTable table(file, "study", {done("third")});
    table.add(failed);
    CHECK(read_points(file, "study").back().outcome.reason == "why");
    table.replace({done("first"), failed, done("third")});
    table.add(done("fourth"));
    const auto rows = read_points(file, "study");
    REQUIRE(rows.size() == 4);
    CHECK(rows[1].point == "second");
    CHECK(rows[3].point == "fourth");
    CHECK(read_points(folder.path / "none.csv", "study").empty());
}

TEST_CASE("a row that was cut is left out, and a table of another study is refused")
{
    const ScratchFolder folder;
    const auto file = folder.path / "points.csv";
    PointTable table(file, "study");
    table.add(done("first"));
    table.add(done("second"));
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 3);
    const auto rows = read_points(file, "study");
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].point == "first");
    CHECK_THROWS_AS(std::ignore = read_points(file, "other"), InputError);
}

TEST_CASE("a row that was edited, and one that another program wrote, are refused with their line")
{
    const ScratchFolder folder;
    const auto file = folder.path / "points.csv";
    const auto refused = [&](const std::string& from, const std::string& to, const std::string& more = "") {
        PointTable table(file, "study");
        table.add(done("first"));
        table.add(done("second"));
        auto text = content(file);
        const auto at = text.find(from, text.find("second"));
        REQUIRE(at != std::string::npos);
        text.replace(at, from.size(), to);
        folder.file("points.csv", text + more);
        return messages::error_of<InputError>([&] { std::ignore = read_points(file, "study"); });
    };
    CHECK(refused("done", "done").empty());
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"-15", "abc"}, {"-15", "-16"}, {"done", "failed"}, {"mark of", "mark off"}, {"1800", ""}}) {
        CAPTURE(to);
        CHECK(messages::has(refused(from, to),
                            "points.csv:6: the row of point 'second' was changed after it was written"));
    }
    // With a checksum that fits, numbers and states are still read as such.
    const auto text = content(file);
    const auto lines = [&] {
        std::vector<std::string> result;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);)
            result.push_back(line);
        return result;
    }();
    const auto heads = lines[3].substr(0, lines[3].rfind(','));
    const auto with = [&](const std::string& from, const std::string& to) {
        auto row = lines[4].substr(0, lines[4].rfind(','));
        row.replace(row.find(from), from.size(), to);
        folder.file("points.csv", lines[0] + '\n' + lines[1] + '\n' + lines[2] + '\n' + lines[3] + '\n' + row + ',' +
                                      checksum_of_row("study", heads, row) + '\n');
        return messages::error_of<InputError>([&] { std::ignore = read_points(file, "study"); });
    };
    CHECK(with("done", "done").empty());
    CHECK(messages::has(with("-15", "abc"), "'abc' is no number"));
    CHECK(messages::has(with("-15", "1e999"), "'1e999' is no number"));
    CHECK(messages::has(with("-15", "nan"), "'nan' is no number"));
    CHECK(messages::has(with("done", "gone"), "'gone' is no state"));
}
