#include "deadpoint/io/vtu.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <type_traits>
#include <zlib.h>

namespace deadpoint {
namespace {

static_assert(std::endian::native == std::endian::little, "files are declared little-endian");
static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as they stand in memory");

constexpr std::size_t block_size = std::size_t{1} << 20;  // [byte] compressed at once
constexpr int compression_level = 3;                      // higher levels take several times longer and save little

std::string comment_lines(const VtuNotes& notes)
{
    std::string result;
    for (const auto& text : notes.comments) {
        result += xml_comment(text);
    }
    return result;
}

/// VTK's compressed block list: number of blocks, block size, size of the last block if partial, compressed sizes,
/// data.
std::string compressed(const void* data, std::size_t bytes)
{
    const auto* const source = static_cast<const Bytef*>(data);
    const std::size_t blocks = (bytes + block_size - 1) / block_size;
    std::vector<std::uint64_t> header{blocks, block_size, bytes % block_size};
    std::string body;
    std::vector<Bytef> buffer(compressBound(block_size));
    for (std::size_t begin = 0; begin < bytes; begin += block_size) {
        uLongf size = buffer.size();
        const auto length = static_cast<uLong>(std::min(block_size, bytes - begin));
        if (compress2(buffer.data(), &size, source + begin, length, compression_level) != Z_OK) {
            throw IoError("cannot compress a field for writing: out of memory\n  help: write fewer fields");
        }
        header.push_back(size);
        body.append(reinterpret_cast<const char*>(buffer.data()), size);
    }
    std::string result(header.size() * sizeof(std::uint64_t), '\0');
    std::memcpy(result.data(), header.data(), result.size());
    return result + body;
}

template <class T>
constexpr const char* type_name()
{
    if constexpr (std::is_same_v<T, float>) {
        return "Float32";
    } else if constexpr (std::is_same_v<T, double>) {
        return "Float64";
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        return "Int32";
    } else if constexpr (std::is_same_v<T, std::uint32_t>) {
        return "UInt32";
    } else {
        return "UInt8";
    }
}

/// The appended section: data of arrays in the order in which their elements were written.
class AppendedWriter {
public:
    template <class T>
    std::string element(const std::string& name, int components, const T* data, std::size_t count)
    {
        std::string line =
            fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)"
                        "\n",
                        type_name<T>(), xml_text(name), components, bytes_.size());
        bytes_ += compressed(data, count * sizeof(T));
        return line;
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

std::size_t nodes_of(VtuCell type)
{
    switch (type) {
    case VtuCell::triangle:
        return 3;
    case VtuCell::quad:
    case VtuCell::tetrahedron:
        return 4;
    case VtuCell::hexahedron:
        return 8;
    }
    return 0;
}

void check(const VtuGrid& grid, std::span<const VtuArray> arrays)
{
    bool good = grid.types.size() == grid.offsets.size();
    std::size_t end = 0;
    for (std::size_t i = 0; good && i < grid.types.size(); ++i) {
        end += nodes_of(grid.types[i]);
        good = grid.offsets[i] == end;
    }
    good = good && end == grid.connectivity.size() &&
           std::ranges::all_of(grid.connectivity, [&](std::uint32_t node) { return node < grid.points.size(); });
    if (!good) {
        throw InputError("cannot write a grid: its cells name missing points or have the wrong number of them");
    }
    for (const auto& array : arrays) {
        const std::size_t places = array.place == VtuArray::Place::point ? grid.points.size() : grid.types.size();
        const std::size_t size = std::visit([](const auto& v) { return v.size(); }, array.values);
        if ((array.components != 1 && array.components != 3) ||
            size != places * static_cast<std::size_t>(array.components)) {
            throw InputError(fmt::format("cannot write the array '{}': {} values for {} {} of {} components (1 or 3)",
                                         array.name, size, places,
                                         array.place == VtuArray::Place::point ? "points" : "cells", array.components));
        }
    }
}

std::string opening(const char* type, const VtuNotes& notes)
{
    return "<?xml version=\"1.0\"?>\n" + comment_lines(notes) +
           fmt::format(R"(<VTKFile type="{}" version="1.0" byte_order="LittleEndian" header_type="UInt64" )"
                       R"(compressor="vtkZLibDataCompressor">)"
                       "\n",
                       type);
}

std::string time_field(const VtuNotes& notes)
{
    return notes.time ? fmt::format("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                                    "format=\"ascii\">{}</DataArray>\n</FieldData>\n",
                                    *notes.time)
                      : std::string{};
}

std::string arrays_at(VtuArray::Place place, std::span<const VtuArray> arrays, AppendedWriter& data)
{
    std::string result;
    for (const auto& array : arrays) {
        if (array.place == place) {
            result += std::visit(
                [&](const auto& v) { return data.element(array.name, array.components, v.data(), v.size()); },
                array.values);
        }
    }
    return result;
}

std::string declared_at(VtuArray::Place place, std::span<const VtuDeclaration> arrays)
{
    constexpr const char* names[] = {"Float32", "Float64", "Int32"};
    std::string result;
    for (const auto& array : arrays) {
        if (array.place == place) {
            result += fmt::format("<PDataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"/>\n",
                                  names[static_cast<int>(array.type)], xml_text(array.name), array.components);
        }
    }
    return result;
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid, std::span<const VtuArray> arrays,
               const VtuNotes& notes)
{
    check(grid, arrays);
    AppendedWriter data;
    std::string head = opening("UnstructuredGrid", notes) + "<UnstructuredGrid>\n" + time_field(notes);
    head += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points.size(), grid.types.size());
    head += "<Points>\n";
    head += data.element("Points", 3, grid.points.empty() ? nullptr : grid.points[0].data(), 3 * grid.points.size());
    head += "</Points>\n<Cells>\n";
    head += data.element("connectivity", 1, grid.connectivity.data(), grid.connectivity.size());
    head += data.element("offsets", 1, grid.offsets.data(), grid.offsets.size());
    head += data.element("types", 1, reinterpret_cast<const std::uint8_t*>(grid.types.data()), grid.types.size());
    head += "</Cells>\n<PointData>\n" + arrays_at(VtuArray::Place::point, arrays, data);
    head += "</PointData>\n<CellData>\n" + arrays_at(VtuArray::Place::cell, arrays, data);
    head += "</CellData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    write_file(path, [&](std::ostream& out) { out << head << data.bytes() << "\n</AppendedData>\n</VTKFile>\n"; });
}

void write_pvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
                std::span<const VtuDeclaration> arrays, const VtuNotes& notes)
{
    std::string text = opening("PUnstructuredGrid", notes) + "<PUnstructuredGrid GhostLevel=\"0\">\n" +
                       time_field(notes) + "<PPointData>\n" + declared_at(VtuArray::Place::point, arrays) +
                       "</PPointData>\n<PCellData>\n" + declared_at(VtuArray::Place::cell, arrays) +
                       "</PCellData>\n<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" "
                       "NumberOfComponents=\"3\"/>\n</PPoints>\n";
    for (const auto& piece : pieces) {
        text += fmt::format("<Piece Source=\"{}\"/>\n", xml_text(piece));
    }
    text += "</PUnstructuredGrid>\n</VTKFile>\n";
    write_file(path, text);
}

void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const auto& entry : entries) {
        text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time, xml_text(entry.file));
    }
    text += "</Collection>\n</VTKFile>\n";
    write_file(path, text);
}

VtuDeclaration declaration(const VtuArray& array)
{
    return {array.name, array.place, array.components, static_cast<VtuDeclaration::Type>(array.values.index())};
}

}  // namespace deadpoint
