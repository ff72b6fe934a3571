#pragma once

#include "deadpoint/core/vec.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Writers of VTK's XML files for unstructured grids, as ParaView, VisIt and PyVista read them (VTK File Formats,
/// Kitware: UnstructuredGrid, version 1.0). Data is appended raw, compressed with zlib, little-endian.
namespace deadpoint {

/// Cell types by their VTK numbers. Nodes of a hexahedron: bottom 0-3 counter-clockwise seen from the top, top 4-7.
enum class VtuCell : std::uint8_t { triangle = 5, quad = 9, tetrahedron = 10, hexahedron = 12 };

/// Points shared by cells. Fill it with add_cell(), or set the three cell members directly.
struct VtuGrid {
    std::vector<Vec3> points;                 ///< [m]
    std::vector<std::uint32_t> connectivity;  ///< point numbers, cell after cell
    std::vector<std::uint32_t> offsets;       ///< per cell: end of its points in `connectivity`
    std::vector<VtuCell> types;               ///< per cell

    /// Appends a cell; the number of nodes must be that of the type (checked when the file is written).
    void add_cell(VtuCell type, std::span<const std::uint32_t> nodes)
    {
        connectivity.insert(connectivity.end(), nodes.begin(), nodes.end());
        offsets.push_back(static_cast<std::uint32_t>(connectivity.size()));
        types.push_back(type);
    }
};

/// Array of the numbers of nodes, from 1, the same in all files of a mesh and in decks of other programs.
inline constexpr const char* node_array_name = "node";

using VtuValues = std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>>;

/// Values at points or in cells; those of a vector follow each other (x, y, z, x, y, z, ...).
struct VtuArray {
    enum class Place { point, cell };
    std::string name;  ///< shown in the viewer; put the unit into it, e.g. "temperature [K]"
    Place place = Place::point;
    int components = 1;  ///< 1 or 3
    VtuValues values;
};

/// Contents of a file besides grid and arrays.
struct VtuNotes {
    std::optional<double> time;         ///< [s], becomes the field "TimeValue"
    std::vector<std::string> comments;  ///< version, case hash, warnings: one XML comment each
};

/// Name and type of an array in a .pvtu file, which must be the same in all its pieces.
struct VtuDeclaration {
    enum class Type { float32, float64, int32 };
    std::string name;
    VtuArray::Place place = VtuArray::Place::point;
    int components = 1;
    Type type = Type::float32;
};

/// One entry of a .pvd series: a time [s] and the file that holds it, relative to the .pvd.
struct PvdEntry {
    double time = 0;
    std::string file;
};

/// Writes a .vtu file; complete or absent (write_file.hpp).
/// @throws InputError if an array's length is not components times points (or cells), if components is not 1 or 3, or
///         if a cell names a missing point or has the wrong number of them
/// @throws IoError if the file cannot be written
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid, std::span<const VtuArray> arrays,
               const VtuNotes& notes = {});

/// Writes a .pvtu file that joins pieces, e.g. of several ranks, given by their paths relative to it.
/// @throws IoError if the file cannot be written
void write_pvtu(const std::filesystem::path& path, std::span<const std::string> pieces,
                std::span<const VtuDeclaration> arrays, const VtuNotes& notes = {});

/// Writes a .pvd file: a series of .vtu or .pvtu files over time.
/// @throws IoError if the file cannot be written
void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

/// The declaration that matches an array.
[[nodiscard]] VtuDeclaration declaration(const VtuArray& array);

}  // namespace deadpoint
