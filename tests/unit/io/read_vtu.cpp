#include "deadpoint/io/read_vtu.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <limits>
#include <zlib.h>

using namespace deadpoint;

namespace {

/// A row of tetrahedra, long enough for several compressed blocks of points.
VtuGrid row_of_tetrahedra(std::uint32_t count)
{
    VtuGrid grid;
    for (std::uint32_t k = 0; k < count + 3; ++k) {
        grid.points.push_back({0.1 * k, k % 2 ? 1.0 / 3 : 0.0, k % 3 ? 0.0 : -2e-7});
    }
    for (std::uint32_t k = 0; k < count; ++k) {
        grid.add_cell(VtuCell::tetrahedron, std::vector<std::uint32_t>{k, k + 1, k + 2, k + 3});
    }
    return grid;
}

std::string written(const ScratchFolder& folder, const VtuGrid& grid, const std::vector<VtuArray>& arrays)
{
    write_vtu(folder.path / "a.vtu", grid, arrays, {std::nullopt, {"a comment with <Points> & \"quotes\""}});
    return content(folder.path / "a.vtu");
}

}  // namespace

TEST_CASE("a field file reads back bit by bit, also where arrays need several blocks")
{
    const ScratchFolder folder;
    for (const std::uint32_t count : {1U, 60'000U}) {  // 60 003 points are 1.4 MB, more than one block of 1 MB
        const auto grid = row_of_tetrahedra(count);
        std::vector<float> values(grid.points.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = 0.3F * static_cast<float>(k);
        }
        const std::vector<std::int32_t> parts(grid.types.size(), -7);
        const auto text = written(
            folder, grid, {{"T [degC]", VtuArray::Place::point, 1, values}, {"part", VtuArray::Place::cell, 1, parts}});
        const auto read = parse_vtu(text, "a.vtu");
        CHECK(read.grid.points == grid.points);
        CHECK(read.grid.connectivity == grid.connectivity);
        CHECK(read.grid.offsets == grid.offsets);
        CHECK(read.grid.types == grid.types);
        REQUIRE(read.find("T [degC]") != nullptr);
        CHECK(std::get<std::vector<float>>(read.find("T [degC]")->values) == values);
        CHECK(std::get<std::vector<std::int32_t>>(read.find("part")->values) == parts);
        CHECK(read.find("other") == nullptr);
    }
}

TEST_CASE("a field file that was cut or changed is refused")
{
    const ScratchFolder folder;
    const auto grid = row_of_tetrahedra(5);
    const auto text = written(folder, grid, {{"T", VtuArray::Place::point, 1, std::vector<float>(8, 1.0F)}});
    for (std::size_t size = 0; size + 34 < text.size(); ++size) {  // the last bytes close elements only
        CHECK_THROWS_AS(parse_vtu(text.substr(0, size), "a.vtu"), InputError);
    }
    for (std::size_t k = 0; k < text.size(); ++k) {
        auto changed = text;
        changed[k] = static_cast<char>(changed[k] ^ 0x15);
        try {
            (void)parse_vtu(changed, "a.vtu");  // may be whole, as in a comment, but never crashes
        } catch (const InputError&) {
        }
    }
}

TEST_CASE("a field file whose values are not finite is refused, and one that would unpack to gigabytes, before it does")
{
    const ScratchFolder folder;
    const auto grid = row_of_tetrahedra(5);
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
        std::vector<float> values(8, 1.0F);
        values.back() = value;
        CHECK_THROWS_AS(parse_vtu(written(folder, grid, {{"T", VtuArray::Place::point, 1, values}}), "a.vtu"),
                        InputError);
    }
    CHECK_THROWS_AS(parse_pvd("<DataSet timestep=\"nan\" file=\"a\"/>", "a.pvd"), InputError);

    // The points as 300 blocks of 2 MB, in some kilobytes.
    auto text = written(folder, grid, {{"T", VtuArray::Place::point, 1, std::vector<float>(8, 1.0F)}});
    const auto data = text.find("<AppendedData encoding=\"raw\">\n_") + 31;
    std::string zeros(1U << 21U, '\0'), packed(compressBound(zeros.size()), '\0');
    uLongf length = packed.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(zeros.data()),
                     zeros.size()) == Z_OK);
    std::string blocks;
    for (const std::uint64_t word : {std::uint64_t{300}, std::uint64_t{zeros.size()}, std::uint64_t{0}})
        blocks.append(reinterpret_cast<const char*>(&word), sizeof word);
    for (int k = 0; k < 300; ++k)
        blocks.append(reinterpret_cast<const char*>(&length), sizeof length);
    for (int k = 0; k < 300; ++k)
        blocks.append(packed, 0, length);
    CHECK_THROWS_AS(parse_vtu(text.substr(0, data) + blocks, "a.vtu"), InputError);
}

TEST_CASE("lists of times and of pieces read back")
{
    const ScratchFolder folder;
    const std::vector<PvdEntry> entries{{600, "fields_0000.vtu"}, {10800.25, "fields_0001.vtu"}};
    write_pvd(folder.path / "a.pvd", entries);
    const auto read = parse_pvd(content(folder.path / "a.pvd"), "a.pvd");
    REQUIRE(read.size() == 2);
    CHECK(read[1].time == 10800.25);
    CHECK(read[1].file == "fields_0001.vtu");
    CHECK_THROWS_AS(parse_pvd("<DataSet timestep=\"soon\" file=\"a\"/>", "a.pvd"), InputError);
    const std::vector<std::string> pieces{"f_0.vtu", "f_1.vtu"};
    write_pvtu(folder.path / "a.pvtu", pieces, {});
    CHECK(parse_pvtu(content(folder.path / "a.pvtu"), "a.pvtu") == pieces);
    CHECK_THROWS_AS(parse_pvtu("<VTKFile>", "a.pvtu"), InputError);
}
