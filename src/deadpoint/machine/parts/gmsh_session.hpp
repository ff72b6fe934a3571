#pragma once

#include <functional>
#include <string>

/// Gmsh behind a scope: it has one global state per process.
namespace deadpoint::machine {

/// Lengths inside Gmsh are millimetres, for which the tolerances of its geometry kernel are made.
inline constexpr double gmsh_unit = 1e-3;
inline double to_gmsh(double length) { return length / gmsh_unit; }

/// Gmsh is initialised, silent and single-threaded while a session lives. Only one session may live at a time.
class GmshSession {
public:
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;
    GmshSession(GmshSession&&) = delete;
    GmshSession& operator=(GmshSession&&) = delete;
};

/// Empties Gmsh's model and sets all options that parts set to their default.
void reset_gmsh();

/// Calls `work`. Exceptions of Gmsh become an InputError that names the part, the step and the
/// remedy; a lack of memory stays a lack of memory.
void guard_gmsh(const std::string& part, const char* step, const std::function<void()>& work);

}  // namespace deadpoint::machine
