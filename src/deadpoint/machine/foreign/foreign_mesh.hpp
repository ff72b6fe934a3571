#pragma once

#include "deadpoint/machine/parts/part_mesh.hpp"

#include <functional>
#include <string>

namespace deadpoint::machine {

/// A file that other programs wrote, read by a library that others wrote.
struct ForeignFile {
    std::string part;
    std::string path;
    /// The name that the library sees instead of the path. Its ending decides which reader Gmsh takes, so no name that
    /// a user gives decides anything.
    std::string name;
};

/// Called about once a second with the seconds so far.
using Waiting = std::function<void(double)>;

/// Runs `make`, which reads the file with the libraries of others, in a child process with at most half of the
/// machine's memory and half an hour, which can open that file and nothing else (io/confine.hpp), and takes the mesh
/// over. Needs a GmshSession.
/// @throws what `make` throws of our errors; InputError naming part and file if the child crashes, hangs, needs too
/// much or does what no reader should
PartMesh mesh_foreign_file(const ForeignFile& file, const std::function<PartMesh()>& make, const Waiting& waiting);

/// What Gmsh says of the file that it reads while this object lives.
class GmshComplaints {
public:
    GmshComplaints();
    ~GmshComplaints();
    GmshComplaints(const GmshComplaints&) = delete;
    GmshComplaints& operator=(const GmshComplaints&) = delete;
    GmshComplaints(GmshComplaints&&) = delete;
    GmshComplaints& operator=(GmshComplaints&&) = delete;
    /// @throws InputError with the first error, since Gmsh goes on with what it has
    void require_none(const ForeignFile& file) const;
};

}  // namespace deadpoint::machine
