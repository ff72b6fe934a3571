#include "deadpoint/io/vtu.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/error.hpp"

#include <cstring>
#include <doctest/doctest.h>
#include <fstream>
#include <numeric>
#include <random>
#include <sstream>
#include <zlib.h>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

using Folder = ScratchFolder;

/// The appended values of one array, read by the format's rules and not by the writer's code.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name, const std::string& type)
{
    const std::size_t element = file.find("<DataArray type=\"" + type + "\" Name=\"" + name + "\"");
    REQUIRE(element != std::string::npos);
    const std::size_t offset = file.find("offset=\"", element) + 8;
    const std::size_t marker = file.find("<AppendedData encoding=\"raw\">\n_") + 31;
    const char* at = file.data() + marker + std::stoull(file.substr(offset));
    const auto number = [&at] {
        std::uint64_t value = 0;
        std::memcpy(&value, at, sizeof value);
        at += sizeof value;
        return value;
    };
    const auto blocks = number();
    const auto block_size = number();
    const auto last = number();
    std::vector<std::uint64_t> sizes(blocks);
    for (auto& size : sizes) {
        size = number();
    }
    std::string bytes;
    for (std::size_t i = 0; i < blocks; ++i) {
        std::string block(block_size, '\0');
        uLongf length = block.size();
        REQUIRE(uncompress(reinterpret_cast<Bytef*>(block.data()), &length, reinterpret_cast<const Bytef*>(at),
                           sizes[i]) == Z_OK);
        REQUIRE(length == (i + 1 == blocks && last != 0 ? last : block_size));
        bytes.append(block, 0, length);
        at += sizes[i];
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

/// A unit cube with a tetrahedron on its top and one of its faces as a quad and a triangle.
VtuGrid sample_grid()
{
    VtuGrid grid;
    grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},    {0, 0, 1},
                   {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}};
    grid.add_cell(VtuCell::hexahedron, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7});
    grid.add_cell(VtuCell::tetrahedron, std::vector<std::uint32_t>{4, 5, 6, 8});
    grid.add_cell(VtuCell::quad, std::vector<std::uint32_t>{0, 3, 2, 1});
    grid.add_cell(VtuCell::triangle, std::vector<std::uint32_t>{4, 5, 8});
    return grid;
}

}  // namespace

TEST_CASE("a .vtu file holds points, cells and arrays exactly as given")
{
    const Folder folder;
    const auto grid = sample_grid();
    std::vector<double> displacement(27);
    std::iota(displacement.begin(), displacement.end(), -3.5);
    const std::vector<VtuArray> arrays{
        {"temperature [K]", VtuArray::Place::point, 1, std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9.5F}},
        {"displacement [m]", VtuArray::Place::point, 3, displacement},
        {"part <1>", VtuArray::Place::cell, 1, std::vector<std::int32_t>{7, -1, 0, 3}},
    };
    write_vtu(folder.path / "a.vtu", grid, arrays, {.time = 60.5, .comments = {"deadpoint -- test"}});
    const auto file = content(folder.path / "a.vtu");

    CHECK(file.find("NumberOfPoints=\"9\" NumberOfCells=\"4\"") != std::string::npos);
    CHECK(file.find("<!-- deadpoint - - test -->") != std::string::npos);
    CHECK(file.find(">60.5</DataArray>") != std::string::npos);
    const auto points = array_of<double>(file, "Points", "Float64");
    REQUIRE(points.size() == 27);
    CHECK(points[26] == 2.0);
    CHECK(array_of<std::uint32_t>(file, "connectivity", "UInt32") == grid.connectivity);
    CHECK(array_of<std::uint32_t>(file, "offsets", "UInt32") == std::vector<std::uint32_t>{8, 12, 16, 19});
    CHECK(array_of<std::uint8_t>(file, "types", "UInt8") == std::vector<std::uint8_t>{12, 10, 9, 5});
    CHECK(array_of<float>(file, "temperature [K]", "Float32")[8] == 9.5F);
    CHECK(array_of<double>(file, "displacement [m]", "Float64") == displacement);
    CHECK(array_of<std::int32_t>(file, "part &lt;1&gt;", "Int32") == std::vector<std::int32_t>{7, -1, 0, 3});
    CHECK_FALSE(fs::exists(folder.path / "a.vtu.part"));
}

TEST_CASE("arrays longer than a compressed block come back whole")
{
    const Folder folder;
    VtuGrid grid;
    grid.points.resize(300000);  // 2.4 MB of doubles: two full blocks of 1 MiB and a rest
    std::vector<double> values(grid.points.size());
    std::iota(values.begin(), values.end(), 0.0);
    write_vtu(folder.path / "b.vtu", grid, std::vector<VtuArray>{{"v", VtuArray::Place::point, 1, values}});
    CHECK(array_of<double>(content(folder.path / "b.vtu"), "v", "Float64") == values);
}

TEST_CASE("a grid or array that does not fit is refused and nothing is written")
{
    const Folder folder;
    const auto path = folder.path / "c.vtu";
    const auto grid = sample_grid();
    const auto write = [&](VtuArray array) { write_vtu(path, grid, std::vector<VtuArray>{std::move(array)}); };
    CHECK_THROWS_AS(write({"x", VtuArray::Place::point, 1, std::vector<double>(8)}), InputError);
    CHECK_THROWS_AS(write({"x", VtuArray::Place::cell, 2, std::vector<double>(8)}), InputError);
    auto broken = grid;
    broken.connectivity[0] = 9;
    CHECK_THROWS_AS(write_vtu(path, broken, {}), InputError);
    broken = grid;
    broken.types[1] = VtuCell::triangle;
    CHECK_THROWS_AS(write_vtu(path, broken, {}), InputError);
    CHECK(fs::is_empty(folder.path));
    CHECK_THROWS_AS(write_vtu(folder.path / "missing" / "c.vtu", grid, {}), IoError);
}

TEST_CASE("a .pvtu file declares what its pieces hold, a .pvd file lists times")
{
    const Folder folder;
    const VtuArray array{"u", VtuArray::Place::cell, 3, std::vector<double>{}};
    const std::vector<std::string> pieces{"p0.vtu", "p1.vtu"};
    write_pvtu(folder.path / "p.pvtu", pieces, std::vector<VtuDeclaration>{declaration(array)});
    const auto pvtu = content(folder.path / "p.pvtu");
    CHECK(pvtu.find("<PCellData>\n<PDataArray type=\"Float64\" Name=\"u\" NumberOfComponents=\"3\"/>") !=
          std::string::npos);
    CHECK(pvtu.find("<Piece Source=\"p1.vtu\"/>") != std::string::npos);

    write_pvd(folder.path / "s.pvd", std::vector<PvdEntry>{{0, "a.vtu"}, {1800.25, "b.vtu"}});
    CHECK(content(folder.path / "s.pvd").find("<DataSet timestep=\"1800.25\" part=\"0\" file=\"b.vtu\"/>") !=
          std::string::npos);
}
