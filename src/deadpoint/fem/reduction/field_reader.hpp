#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/io/binary_file.hpp"

#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

/// The file of a reduced model's fields (docs/rom-file.md) as such: without a mesh, on one rank.
namespace deadpoint::fem {

inline constexpr std::string_view fields_kind = "deadpoint fields of a reduced press 1\n";

/// Head of the file.
struct FieldFileHead {
    std::string version;  ///< of the program
    std::string model;    ///< reduce::mark_of() the terms that were projected on these fields
    std::string mesh;     ///< file_order's mesh_text()
};
constexpr auto members(const FieldFileHead*)
{
    return std::tuple{&FieldFileHead::version, &FieldFileHead::model, &FieldFileHead::mesh};
}

/// Reads the fields one after the other.
class FieldReader {
public:
    /// @param own       model and mesh that the fields must have
    /// @param states    number of fields
    /// @param unknowns  numbers of each
    /// @throws IoError if the file cannot be read, was cut short or changed; InputError if it belongs to another model
    ///         or another mesh
    FieldReader(const std::string& file, const FieldFileHead& own, std::size_t states, std::size_t unknowns)
        : reader_(file, fields_kind, help), unknowns_(unknowns)
    {
        FieldFileHead head;
        std::uint64_t count = 0;
        reader_(head, count);
        if (head.model != own.model)
            throw InputError(fmt::format("the fields in '{}' belong to another reduced press than this one\n  help: {}",
                                         file, help));
        if (head.mesh != own.mesh)
            throw InputError(fmt::format("the fields in '{}' belong to another mesh than that of this case\n  it is:  "
                                         "{}\n  wanted: {}\n  help: {}",
                                         file, head.mesh, own.mesh, help));
        if (count != states)
            reader_.refuse(fmt::format("it has {} fields for {} states", count, states));
    }
    /// @throws IoError if the file holds another number of values than are due
    [[nodiscard]] std::vector<float> next()
    {
        std::vector<float> field;
        reader_(field);
        if (field.size() != unknowns_)
            reader_.refuse("its numbers do not fit the mesh");
        return field;
    }

private:
    static constexpr const char* help = "make it again with 'deadpoint reduce CASE --fields -o FILE', or remove it";
    BinaryReader reader_;
    std::size_t unknowns_ = 0;
};

}  // namespace deadpoint::fem
