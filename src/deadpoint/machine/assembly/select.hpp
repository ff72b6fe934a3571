#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace deadpoint {
struct MeshSurface;
struct SurfaceDescription;
struct SurfaceSelector;
class InputError;
}  // namespace deadpoint

namespace deadpoint::machine {

struct Assembly;

/// Parts a selector names, ascending.
/// @throws InputError when a name or pattern matches no part; `dropped` are the parts beyond the symmetry plane
std::vector<std::uint32_t> selected_parts(const Assembly& assembly, const SurfaceSelector& selector,
                                          const std::string& owner);

/// Faces that fit a selector's kind and parts, without regard to `within`; never those on the symmetry plane.
std::vector<std::uint32_t> selected_faces(const Assembly& assembly, const SurfaceSelector& selector,
                                          const std::string& owner);

/// The surface of a selector: faces by the shares of their areas that are exposed and lie in its box.
/// @throws InputError with a hint when no face matches, or none has its centre in the box (an exposed selector may be
///         empty)
MeshSurface select_surface(const Assembly& assembly, const SurfaceDescription& description);

/// "the cylinder of diameter 90 mm along z about (0, -25) mm of part 'link_3'", for messages.
std::string describe(const SurfaceSelector& selector);

/// The error that a selector matches no face: which faces there are instead, the nearest first, and what to change.
InputError no_face(const Assembly& assembly, const SurfaceSelector& selector, const std::string& owner);

}  // namespace deadpoint::machine
