#pragma once

#include "deadpoint/io/vtu.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Readers of the files that io/vtu.hpp writes. They read no other VTK files.
namespace deadpoint {

/// A .vtu file, read back.
struct VtuContents {
    VtuGrid grid;
    std::vector<VtuArray> arrays;

    /// An array by its name; null if there is none.
    [[nodiscard]] const VtuArray* find(std::string_view name) const;
};

/// @param text  of the .vtu file
/// @param file  its name in messages
/// @throws InputError if it is not as write_vtu() writes it
VtuContents parse_vtu(std::string_view text, const std::string& file);

/// The pieces that a .pvtu file names.
/// @throws InputError if it names none
std::vector<std::string> parse_pvtu(std::string_view text, const std::string& file);

/// The entries of a .pvd file, in its order.
/// @throws InputError if an entry has no time or no file
std::vector<PvdEntry> parse_pvd(std::string_view text, const std::string& file);

}  // namespace deadpoint
