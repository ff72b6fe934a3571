#include "deadpoint/io/read_vtu.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <optional>
#include <type_traits>
#include <zlib.h>

namespace deadpoint {
namespace {

constexpr std::string_view data_mark = "<AppendedData encoding=\"raw\">\n_";
constexpr std::uint64_t largest_block = std::uint64_t{1} << 24;  // [byte]; sixteen times what the writer makes
// A file may unpack to no more than this [byte] and that many times its size, whatever its blocks say. Points and cells
// of regular meshes shrink to a tenth, so that files of this program stay below.
constexpr std::uint64_t largest_small = std::uint64_t{1} << 26, largest_growth = 30;

[[noreturn]] void refuse(const std::string& file)
{
    throw InputError(
        fmt::format("'{}' is not a field file of deadpoint, or was cut short\n  help: compute the case again", file));
}

/// Value of an attribute of an XML element; empty if it has none of that name.
std::string_view attribute(std::string_view element, std::string_view name)
{
    const auto mark = fmt::format(" {}=\"", name);
    const auto at = element.find(mark);
    if (at == std::string_view::npos) {
        return {};
    }
    const auto from = at + mark.size();
    const auto end = element.find('"', from);
    return end == std::string_view::npos ? std::string_view{} : element.substr(from, end - from);
}

template <class Number>
Number number(std::string_view text, const std::string& file)
{
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        refuse(file);
    }
    return value;
}

/// All elements of a name between two places, from '<' to '>'.
std::vector<std::string_view> elements(std::string_view text, std::string_view name)
{
    const auto mark = fmt::format("<{} ", name);
    std::vector<std::string_view> found;
    for (auto at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
        const auto end = std::min(text.find('>', at), text.size());
        found.push_back(text.substr(at, end - at));
    }
    return found;
}

/// What is between "<name>" and "</name>".
std::string_view section(std::string_view text, std::string_view name)
{
    const auto open = fmt::format("<{}>", name), close = fmt::format("</{}>", name);
    const auto at = text.find(open);
    const auto end = text.find(close, std::min(at, text.size()));
    return end == std::string_view::npos ? std::string_view{} : text.substr(at + open.size(), end - at - open.size());
}

/// The appended section of a file.
class AppendedReader {
public:
    AppendedReader(std::string_view bytes, const std::string& file)
        : bytes_(bytes), file_(file), left_(largest_small + largest_growth * bytes.size())
    {}

    template <class T>
    std::vector<T> read(std::string_view element)
    {
        const std::string raw = inflated(number<std::uint64_t>(attribute(element, "offset"), file_));
        std::vector<T> values(raw.size() / sizeof(T));
        if (values.size() * sizeof(T) != raw.size()) {
            refuse(file_);
        }
        std::copy_n(raw.data(), raw.size(), reinterpret_cast<char*>(values.data()));
        if constexpr (std::is_floating_point_v<T>) {
            if (!std::ranges::all_of(values, [](T value) { return std::isfinite(value); })) {
                refuse(file_);
            }
        }
        return values;
    }

private:
    [[nodiscard]] std::string_view take(std::uint64_t& at, std::uint64_t count) const
    {
        if (at > bytes_.size() || count > bytes_.size() - at) {
            refuse(file_);
        }
        at += count;
        return bytes_.substr(at - count, count);
    }
    [[nodiscard]] std::uint64_t word(std::uint64_t& at) const
    {
        std::uint64_t value = 0;
        std::memcpy(&value, take(at, sizeof value).data(), sizeof value);
        return value;
    }
    /// VTK's list of compressed blocks: their number, their size, the size of a shorter last one, compressed sizes.
    [[nodiscard]] std::string inflated(std::uint64_t at)
    {
        const auto blocks = word(at), size = word(at), last = word(at);
        if (blocks > bytes_.size() || size > largest_block || last > size || blocks * size > left_) {
            refuse(file_);
        }
        left_ -= blocks * size;
        std::vector<std::uint64_t> sizes(blocks);
        std::ranges::generate(sizes, [&] { return word(at); });
        std::string result;
        for (std::uint64_t k = 0; k < blocks; ++k) {
            uLongf length = k + 1 == blocks && last > 0 ? last : size;
            const auto expected = length;
            std::string block(length, '\0');
            const auto packed = take(at, sizes[k]);
            if (uncompress(reinterpret_cast<Bytef*>(block.data()), &length,
                           reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
                length != expected) {
                refuse(file_);
            }
            result += block;
        }
        return result;
    }

    std::string_view bytes_;
    const std::string& file_;
    std::uint64_t left_;  ///< that may still be unpacked [byte]
};

VtuValues values_of(std::string_view element, AppendedReader& data, const std::string& file)
{
    const auto type = attribute(element, "type");
    if (type == "Float32") {
        return data.read<float>(element);
    }
    if (type == "Float64") {
        return data.read<double>(element);
    }
    if (type == "Int32") {
        return data.read<std::int32_t>(element);
    }
    refuse(file);
}

void add_arrays(std::string_view text, VtuArray::Place place, AppendedReader& data, const std::string& file,
                VtuContents& contents)
{
    const std::size_t places =
        place == VtuArray::Place::point ? contents.grid.points.size() : contents.grid.types.size();
    for (const auto element : elements(text, "DataArray")) {
        const auto components = number<int>(attribute(element, "NumberOfComponents"), file);
        VtuArray array{std::string(attribute(element, "Name")), place, components, values_of(element, data, file)};
        const auto size = std::visit([](const auto& v) { return v.size(); }, array.values);
        if (components < 1 || size != places * static_cast<std::size_t>(components)) {
            refuse(file);
        }
        contents.arrays.push_back(std::move(array));
    }
}

VtuGrid grid_of(std::string_view head, AppendedReader& data, const std::string& file)
{
    const auto points = elements(section(head, "Points"), "DataArray");
    const auto cells = elements(section(head, "Cells"), "DataArray");
    if (points.size() != 1 || cells.size() != 3) {
        refuse(file);
    }
    VtuGrid grid;
    const auto coordinates = data.read<double>(points[0]);
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
        grid.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    }
    grid.connectivity = data.read<std::uint32_t>(cells[0]);
    grid.offsets = data.read<std::uint32_t>(cells[1]);
    for (const auto type : data.read<std::uint8_t>(cells[2])) {
        grid.types.push_back(static_cast<VtuCell>(type));
    }
    return grid;
}

std::uint32_t corners_of(VtuCell type)
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

bool is_sound(const VtuGrid& grid)
{
    std::uint32_t end = 0;
    for (std::size_t c = 0; c < std::min(grid.types.size(), grid.offsets.size()); ++c) {
        const auto corners = corners_of(grid.types[c]);
        end += corners;
        if (corners == 0 || grid.offsets[c] != end) {
            return false;
        }
    }
    return grid.types.size() == grid.offsets.size() && end == grid.connectivity.size() &&
           std::ranges::all_of(grid.connectivity, [&](auto node) { return node < grid.points.size(); });
}

}  // namespace

const VtuArray* VtuContents::find(std::string_view name) const
{
    const auto found = std::ranges::find(arrays, name, &VtuArray::name);
    return found == arrays.end() ? nullptr : &*found;
}

VtuContents parse_vtu(std::string_view text, const std::string& file)
{
    const auto mark = text.find(data_mark);
    if (mark == std::string_view::npos) {
        refuse(file);
    }
    const auto head = text.substr(0, mark);
    AppendedReader data(text.substr(mark + data_mark.size()), file);
    VtuContents contents{grid_of(head, data, file), {}};
    if (!is_sound(contents.grid)) {
        refuse(file);
    }
    add_arrays(section(head, "PointData"), VtuArray::Place::point, data, file, contents);
    add_arrays(section(head, "CellData"), VtuArray::Place::cell, data, file, contents);
    return contents;
}

std::vector<std::string> parse_pvtu(std::string_view text, const std::string& file)
{
    std::vector<std::string> pieces;
    for (const auto element : elements(text, "Piece")) {
        pieces.emplace_back(attribute(element, "Source"));
    }
    if (pieces.empty()) {
        refuse(file);
    }
    return pieces;
}

std::vector<PvdEntry> parse_pvd(std::string_view text, const std::string& file)
{
    std::vector<PvdEntry> entries;
    for (const auto element : elements(text, "DataSet")) {
        const auto name = attribute(element, "file");
        if (name.empty()) {
            refuse(file);
        }
        const auto time = number<double>(attribute(element, "timestep"), file);
        if (!std::isfinite(time)) {
            refuse(file);
        }
        entries.push_back({time, std::string(name)});
    }
    return entries;
}

}  // namespace deadpoint
