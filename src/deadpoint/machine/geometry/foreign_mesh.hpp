#pragma once

#include "deadpoint/machine/geometry/part_mesh.hpp"

#include <functional>
#include <string>

namespace deadpoint::machine {

/// A file of another program, read by a foreign library.
struct ForeignFile {
    std::string part;
    std::string path;
    /// The name that the library sees instead of the path. Its ending selects the reader of Gmsh,
    /// so the user's file name has no influence.
    std::string name;
};

/// Called about once a second with the seconds so far.
using Waiting = std::function<void(double)>;

/// Runs `make`, which reads or meshes the file with foreign libraries, in a child process, and returns its
/// mesh. The child has at most half of the machine's memory and half an hour, and can open that
/// file only (io/confine.hpp). Needs a GmshSession.
/// @param doing  "reading", "meshing": begins the messages
/// @throws deadpoint errors of `make`; InputError naming part and file if the child crashes, hangs,
/// needs too much memory or makes a forbidden call
PartMesh mesh_foreign_file(const ForeignFile& file, const char* doing, const std::function<PartMesh()>& make,
                           const Waiting& waiting);

/// Messages of Gmsh about the file that it reads while this object lives.
class GmshComplaints {
public:
    GmshComplaints();
    ~GmshComplaints();
    GmshComplaints(const GmshComplaints&) = delete;
    GmshComplaints& operator=(const GmshComplaints&) = delete;
    GmshComplaints(GmshComplaints&&) = delete;
    GmshComplaints& operator=(GmshComplaints&&) = delete;
    /// The first error that holds a text; empty: none.
    [[nodiscard]] std::string first(const std::string& text = "") const;
    /// @throws InputError with the first error, since Gmsh itself continues with the data it has
    void require_none(const ForeignFile& file) const;
};

}  // namespace deadpoint::machine
