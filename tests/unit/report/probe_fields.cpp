#include "deadpoint/report/probe/probe_fields.hpp"

#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/vtu.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

/// One skewed hexahedron 40 x 20 x 20 mm beside one tetrahedron, of parts 0 and 1.
VtuGrid two_cells()
{
    VtuGrid grid;
    grid.points = {{0, 0, 0},    {0.04, 0.002, 0}, {0.043, 0.02, 0.001}, {0, 0.021, 0},
                   {0, 0, 0.02}, {0.04, 0, 0.022}, {0.04, 0.02, 0.02},   {-0.001, 0.02, 0.02},
                   {0.1, 0, 0},  {0.13, 0, 0},     {0.1, 0.03, 0},       {0.1, 0, 0.03}};
    grid.add_cell(VtuCell::hexahedron, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7});
    grid.add_cell(VtuCell::tetrahedron, std::vector<std::uint32_t>{8, 9, 10, 11});
    return grid;
}

/// Which is linear, so that the elements hold it exactly.
double celsius(const Vec3& x, double time) { return 20 + 0.01 * time + 300 * x[0] - 200 * x[1] + 50 * x[2]; }

std::vector<VtuArray> arrays(const VtuGrid& grid, const std::vector<std::int32_t>& parts, double time)
{
    std::vector<float> values, moved;
    for (const auto& x : grid.points) {
        values.push_back(static_cast<float>(celsius(x, time)));
        moved.insert(moved.end(), {static_cast<float>(x[1]), static_cast<float>(time), -1.0F});
    }
    return {{"temperature [degC]", VtuArray::Place::point, 1, values},
            {"displacement [mm]", VtuArray::Place::point, 3, moved},
            {"part", VtuArray::Place::cell, 1, parts}};
}

/// The cells of one part, as a rank of its own writes them.
VtuGrid cell_alone(const VtuGrid& grid, std::size_t cell)
{
    VtuGrid alone;
    std::vector<std::uint32_t> nodes;
    for (std::size_t k = cell == 0 ? 0 : grid.offsets[cell - 1]; k < grid.offsets[cell]; ++k) {
        nodes.push_back(static_cast<std::uint32_t>(alone.points.size()));
        alone.points.push_back(grid.points[grid.connectivity[k]]);
    }
    alone.add_cell(grid.types[cell], nodes);
    return alone;
}

/// Results at two times: the first as one file, the second as the files of two ranks.
void write_results(const ScratchFolder& folder, bool ranks)
{
    const auto grid = two_cells();
    write_vtu(folder.path / "fields_0000.vtu", grid, arrays(grid, {0, 1}, 600));
    const std::vector<PvdEntry> entries{{600, "fields_0000.vtu"}, {1200, "fields_0001.vtu"}};
    write_vtu(folder.path / "fields_0001.vtu", grid, arrays(grid, {0, 1}, 1200));
    if (!ranks) {
        write_pvd(folder.path / "fields.pvd", entries);
        return;
    }
    std::vector<PvdEntry> of_ranks;
    for (const auto& [time, file] : entries) {
        const auto stem = file.substr(0, file.size() - 4);
        for (const int rank : {0, 1}) {
            const auto alone = cell_alone(grid, static_cast<std::size_t>(rank));
            write_vtu(folder.path / (stem + "_" + std::to_string(rank) + ".vtu"), alone, arrays(alone, {rank}, time));
        }
        const std::vector<std::string> pieces{stem + "_0.vtu", stem + "_1.vtu"};
        write_pvtu(folder.path / (stem + ".pvtu"), pieces, {});
        of_ranks.push_back({time, stem + ".pvtu"});
    }
    write_pvd(folder.path / "fields.pvd", of_ranks);
}

casefile::Case two_parts()
{
    casefile::Case input;
    input.parts["block"] = {};
    input.parts["wedge"] = {};
    return input;
}

report::ProbedFields probed(const ScratchFolder& folder, const std::vector<std::string>& at)
{
    return report::probe_fields(report::ResultFiles(folder.path), two_parts(), report::probe_places(at));
}

}  // namespace

TEST_CASE("a linear field is exact at any place, from the file of one rank or of several")
{
    for (const bool ranks : {false, true}) {
        const ScratchFolder folder;
        write_results(folder, ranks);
        report::write_manifest(folder.path);
        const auto fields = probed(folder, {"block,13 mm,7 mm,11.5 mm", "in=wedge,10.5 cm,0.004 m,3 mm"});
        CHECK(fields.times == std::vector<double>{600, 1200});
        REQUIRE(fields.places.size() == 2);
        CHECK(fields.places[0].place.name == "block,13 mm,7 mm,11.5 mm");
        CHECK(fields.places[1].place.name == "in");
        CHECK(fields.places[0].outside == 0);
        for (const std::size_t k : {0U, 1U}) {
            const double time = fields.times[k];
            // Files hold floats: 4e-6 of 40 degC at most.
            CHECK(fields.places[0].temperature[k] == near(celsius({0.013, 0.007, 0.0115}, time), 1e-6));
            CHECK(fields.places[1].temperature[k] == near(celsius({0.105, 0.004, 0.003}, time), 1e-6));
            CHECK(fields.places[0].displacement[k][0] == near(0.007, 1e-6));
            CHECK(fields.places[0].displacement[k][1] == near(time, 1e-6));
        }
        const auto columns = report::probe_columns(fields);
        REQUIRE(columns.size() == 9);
        CHECK(columns[5].name == "in temperature");
        CHECK(columns[4].unit == "um");
        CHECK(std::get<std::vector<double>>(columns[4].values)[0] == near(-1000, 1e-5));
    }
}

TEST_CASE("a place little outside takes the nearest one in a cell, a place farther out is refused with it")
{
    const ScratchFolder folder;
    write_results(folder, false);
    report::write_manifest(folder.path);
    const auto beside = probed(folder, {"wedge,105 mm,5 mm,-1 mm"});  // 1 mm of a cell of 30 mm
    CHECK(beside.places[0].outside == near(1e-3, 1e-5));
    CHECK(beside.places[0].temperature[0] == near(celsius({0.105, 0.005, 0}, 600), 1e-6));
    const auto far = messages::error_of([&] { probed(folder, {"wedge,105 mm,5 mm,-8 mm"}); });
    CHECK(far.find("8 mm outside of part 'wedge'") != std::string::npos);
    CHECK(far.find("its nearest place is 105 mm,5 mm,0 mm") != std::string::npos);
    // Off the slanted face x + y + z = 0.13 m by 10 mm sqrt(3) from (110, 10, 10) mm.
    CHECK(messages::error_of([&] { probed(folder, {"wedge,120 mm,20 mm,20 mm"}); }).find("110 mm,10 mm,10 mm") !=
          std::string::npos);
}

TEST_CASE("wrong places and results without fields are refused with a remedy")
{
    const ScratchFolder folder;
    write_results(folder, false);
    report::write_manifest(folder.path);
    CHECK(messages::error_of([&] { probed(folder, {"wege,0 mm,0 mm,0 mm"}); }).find("did you mean 'wedge'?") !=
          std::string::npos);
    CHECK(messages::error_of([&] { report::probe_places({"wedge,0 mm,0 mm"}); }).find("three coordinates") !=
          std::string::npos);
    CHECK(messages::error_of([&] {
              report::probe_places({"wedge,0 mm,5,0 mm"});
          }).find("y of the place: '5' has no unit") != std::string::npos);
    CHECK(messages::error_of([&] {
              report::probe_places({"a=w,0 mm,0 mm,0 mm", "a=w,1 mm,0 mm,0 mm"});
          }).find("two places 'a'") != std::string::npos);
    const ScratchFolder bare;
    report::write_manifest(bare.path);
    CHECK(messages::error_of([&] { probed(bare, {"wedge,0 mm,0 mm,0 mm"}); }).find("output.field_times") !=
          std::string::npos);
}
